// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace toss {

/// One UDP datagram of a capture, whole: IP fragments are put together.
struct UdpPacket {
  /// When it was captured [ns, UNIX time by the capturing computer's clock]; of a datagram in
  /// fragments, when the last of them came.
  std::int64_t captureTime = 0;
  /// IPv4 address of the sender, first byte highest (192.0.2.1 is 0xC0000201), and its port.
  std::uint32_t sourceAddress = 0;
  std::uint16_t sourcePort = 0;
  /// Port that it was sent to.
  std::uint16_t destinationPort = 0;
  /// What it carries, shape [size]; belongs to the reader and is valid until its next call.
  const std::uint8_t* payload = nullptr;
  std::size_t size = 0;
};

/// What reading a capture has found so far.
struct UdpPacketReport {
  /// Frames read, UDP datagrams delivered, and frames that hold no UDP over IPv4.
  std::uint64_t frames = 0, packets = 0, otherFrames = 0;
  /// Frames that the capture holds only in part (snap length) or whose lengths contradict each
  /// other, and datagrams of which fragments are missing. Neither is delivered.
  std::uint64_t cutFrames = 0, incompletePackets = 0;
  /// Why the file could not be read to its end; "" where it could.
  std::string damage;
};

/// Reads the UDP datagrams of a capture (pcap or pcapng) one at a time, in the file's order, in
/// constant memory. Knows Ethernet with VLAN tags, Linux cooked (1 and 2), raw IP and loopback.
class UdpPacketReader {
 public:
  /// Throws UserError where the file can't be opened, is no capture, or was captured from a kind of
  /// link other than these.
  explicit UdpPacketReader(const std::filesystem::path& file);
  ~UdpPacketReader();

  /// Reads the next datagram into `packet`; false at the end of the file or at damage in it, which
  /// report().damage then tells: what lies before it is delivered.
  bool next(UdpPacket& packet);
  /// Share of the file that has been read, 0 to 1.
  double progress() const;
  const UdpPacketReport& report() const;
  /// Plain sentences for the user, beginning with the file: damage, cut frames, lost fragments.
  std::vector<std::string> warnings() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
