// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservationVelodyneScan.h>
#include <toss/import/UdpPackets.h>
#include <toss/import/VelodyneImport.h>

#include <cstdint>
#include <string>

namespace toss {

using VelodyneRawPacket = mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket;

/// Whether a datagram is a data packet: its size, and the marks of its blocks.
bool isVelodyneData(const UdpPacket& packet);
/// Whether a datagram is a position packet: its size.
bool isVelodynePosition(const UdpPacket& packet);
/// A data packet in MRPT's type.
VelodyneRawPacket velodyneRawPacket(const UdpPacket& packet);
/// Whether blocks of the lower bank of lasers are in it: only an HDL-64E has one.
bool hasLowerBank(const VelodyneRawPacket& packet);

/// "192.168.1.201" of an address.
std::string addressText(std::uint32_t address);
/// Whether the options' source lets datagrams of this sender through.
bool isFromSource(const UdpPacket& packet, const VelodyneImportOptions& options);
/// Whether their port, too, does: that of data packets.
bool isChosenData(const UdpPacket& packet, const VelodyneImportOptions& options);

}  // namespace toss
