// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/rawlog/TileFolder.h>

#include <fstream>

#include "OutputStream.h"

namespace toss {

std::filesystem::path TileFolder::fileOf(std::uint64_t tile) const {
  return temporary_->temporaryPath() / (std::to_string(tile) + ".tile");
}

void TileFolder::store(std::uint64_t tile, const std::vector<std::uint8_t>& bytes) {
  if (!temporary_) temporary_ = std::make_unique<AtomicFolder>(folder_);
  const std::filesystem::path file = fileOf(tile);
  OutputStream out(file, file.string(), OutputStream::Format::Plain);
  out.Write(bytes.data(), bytes.size());
  out.close();
  ++stored_;
}

void TileFolder::load(std::uint64_t tile, std::vector<std::uint8_t>& bytes) {
  const std::filesystem::path file = fileOf(tile);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  bytes.resize(error ? 0 : size);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (error || !in)
    throw UserError(file.string(), "a part of the map that was put there can't be read back",
                    "leave the folder alone while the program runs, and check the disk");
  ++loaded_;
}

}  // namespace toss
