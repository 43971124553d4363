// SPDX-License-Identifier: BSD-3-Clause
#include <pcap/pcap.h>
#include <toss/geometry/Error.h>
#include <toss/import/UdpPackets.h>

#include <algorithm>
#include <cstdio>
#include <system_error>

#include "IpFragments.h"
#include "LinkLayer.h"

namespace toss {
namespace {

constexpr std::uint8_t kUdp = 17;
constexpr std::size_t kUdpHeader = 8;

struct CloseCapture {
  void operator()(pcap_t* capture) const { pcap_close(capture); }
};
using Capture = std::unique_ptr<pcap_t, CloseCapture>;

Capture openCapture(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored))
    throw UserError(file.string(), "is no file", "give a capture made with tcpdump or Wireshark");
  char reason[PCAP_ERRBUF_SIZE] = {};
  Capture capture(
      pcap_open_offline_with_tstamp_precision(file.c_str(), PCAP_TSTAMP_PRECISION_NANO, reason));
  if (!capture)
    throw UserError(file.string(), "can't be read as a capture (" + std::string(reason) + ")",
                    "give a .pcap or .pcapng file, not compressed");
  const int link = pcap_datalink(capture.get());
  if (knowsLink(link)) return capture;
  const char* name = pcap_datalink_val_to_name(link);
  throw UserError(file.string(),
                  "was captured from a link of kind " +
                      (name ? std::string(name) : std::to_string(link)) + ", which is not known",
                  "capture from an Ethernet card");
}

/// Payload of a UDP datagram; false where it is not all there.
bool parseUdp(Bytes datagram, UdpPacket& packet) {
  if (datagram.size < kUdpHeader) return false;
  // Jumbo datagrams tell a length of 0.
  const std::size_t told = networkUint16(datagram.data + 4);
  const std::size_t length = told == 0 ? datagram.size : told;
  if (length < kUdpHeader || length > datagram.size) return false;
  packet.sourcePort = networkUint16(datagram.data);
  packet.destinationPort = networkUint16(datagram.data + 2);
  packet.payload = datagram.data + kUdpHeader;
  packet.size = length - kUdpHeader;
  return true;
}

}  // namespace

struct UdpPacketReader::Implementation {
  explicit Implementation(const std::filesystem::path& path)
      : file(path), capture(openCapture(path)), link(pcap_datalink(capture.get())) {
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    if (!error) fileSize = static_cast<double>(size);
  }

  /// The next frame; false at the end of the file.
  bool nextFrame(Bytes& frame, std::int64_t& time) {
    pcap_pkthdr* header = nullptr;
    const u_char* data = nullptr;
    const int result = pcap_next_ex(capture.get(), &header, &data);
    if (result == PCAP_ERROR) report.damage = pcap_geterr(capture.get());
    if (result != 1) return false;
    ++report.frames;
    frame = {data, header->caplen};
    time = static_cast<std::int64_t>(header->ts.tv_sec) * 1'000'000'000 + header->ts.tv_usec;
    return true;
  }

  /// Whether the frame completes a UDP datagram.
  bool take(Bytes frame, std::int64_t time, UdpPacket& packet) {
    const Bytes datagram = ipv4Datagram(frame, link);
    if (datagram.data == nullptr || datagram.data[9] != kUdp) {
      ++report.otherFrames;
      return false;
    }
    Ipv4Packet ip;
    if (!parseIpv4(datagram, ip)) {
      ++report.cutFrames;
      return false;
    }
    const Bytes whole = ip.isFragment() ? fragments.add(ip, time) : ip.payload;
    if (whole.data == nullptr) return false;
    packet.captureTime = time;
    packet.sourceAddress = ip.source;
    const bool parsed = parseUdp(whole, packet);
    report.packets += parsed;
    report.cutFrames += !parsed;
    return parsed;
  }

  std::filesystem::path file;
  Capture capture;
  int link;
  double fileSize = 0.0;
  IpFragments fragments;
  bool ended = false;
  UdpPacketReport report;
};

UdpPacketReader::UdpPacketReader(const std::filesystem::path& file)
    : implementation_(std::make_unique<Implementation>(file)) {}

UdpPacketReader::~UdpPacketReader() = default;

bool UdpPacketReader::next(UdpPacket& packet) {
  Implementation& my = *implementation_;
  Bytes frame;
  std::int64_t time = 0;
  while (!my.ended) {
    my.ended = !my.nextFrame(frame, time);
    const bool complete = !my.ended && my.take(frame, time, packet);
    my.report.incompletePackets = my.fragments.lost() + (my.ended ? my.fragments.waiting() : 0);
    if (complete) return true;
  }
  return false;
}

double UdpPacketReader::progress() const {
  const long place = std::ftell(pcap_file(implementation_->capture.get()));
  if (place < 0 || implementation_->fileSize <= 0.0) return 0.0;
  return std::min(1.0, static_cast<double>(place) / implementation_->fileSize);
}

const UdpPacketReport& UdpPacketReader::report() const {
  return implementation_->report;
}

std::vector<std::string> UdpPacketReader::warnings() const {
  const UdpPacketReport& report = implementation_->report;
  std::vector<std::string> warnings;
  const auto warn = [&](const std::string& text) {
    warnings.push_back(implementation_->file.string() + ": " + text);
  };
  if (!report.damage.empty())
    warn("damaged or cut short after frame " + std::to_string(report.frames) + " (" +
         report.damage + "); what lies before it is used");
  if (report.cutFrames > 0)
    warn(std::to_string(report.cutFrames) +
         " frames are not whole and were left out; capture with the full snap length");
  if (report.incompletePackets > 0)
    warn(std::to_string(report.incompletePackets) +
         " packets were left out, some of their IP fragments are missing");
  return warnings;
}

}  // namespace toss
