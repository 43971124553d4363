// SPDX-License-Identifier: BSD-3-Clause
#include "ResourceReport.h"

#include <sys/resource.h>
#include <toss/rawlog/AtomicFile.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace toss {
namespace {

/// Model of the processor as Linux names it, "" where it does not.
std::string processorName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
      return line.substr(colon + 2);
  }
  return {};
}

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

void ResourceReport::write(const std::filesystem::path& file, std::uint64_t scans) const {
  constexpr std::uint64_t kKilobyte = 1024;
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const double wall = std::chrono::duration<double>(Clock::now() - start_).count();
  const nlohmann::ordered_json json = {
      {"threads", threads_},
      {"processor", processorName()},
      {"wall_seconds", wall},
      {"processor_seconds", secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime)},
      {"scans_per_second", static_cast<double>(scans) / wall},
      {"peak_memory_bytes", static_cast<std::uint64_t>(usage.ru_maxrss) * kKilobyte}};
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  writeTextAtomically(file, json.dump(2, ' ', false, replace) + "\n");
}

}  // namespace toss
