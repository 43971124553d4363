// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/io/CFileGZInputStream.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>

#include "InputFixtures.h"

/// Running the program as a user does.
namespace toss::test {

/// What a run of the program has left.
struct ProgramRun {
  /// Exit code; 128 + the signal where one ended it.
  int code = -1;
  std::string out, error;
};

inline std::string quoted(const std::string& text) {
  return "'" + text + "'";
}

/// Runs the program with `arguments`, which the shell splits; `before` goes before it.
inline ProgramRun runProgram(const std::string& arguments, const std::string& before = "") {
  const TemporaryFolder folder;
  const std::string command = before + " " + quoted(TOSS_PROGRAM) + " " + arguments + " >" +
                              quoted(folder / "out") + " 2>" + quoted(folder / "error");
  const int status = std::system(command.c_str());
  ProgramRun run;
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = readBytes(folder / "out");
  run.error = readBytes(folder / "error");
  return run;
}

/// Runs the program and expects it to do what it is asked for.
inline ProgramRun runWell(const std::string& arguments) {
  ProgramRun run = runProgram("-q " + arguments);
  EXPECT_EQ(run.code, 0) << "toss " << arguments << "\n" << run.error;
  return run;
}

/// Expects exit code 1 and a single line on standard error; returns that line.
inline std::string complaintOf(const std::string& arguments, const std::string& before = "") {
  const ProgramRun run = runProgram("-q " + arguments, before);
  EXPECT_EQ(run.code, 1) << "toss " << arguments << "\n" << run.error;
  EXPECT_EQ(std::count(run.error.begin(), run.error.end(), '\n'), 1) << run.error;
  EXPECT_EQ(run.error.rfind("toss: ", 0), 0u) << run.error;
  EXPECT_EQ(run.out, "");
  return run.error;
}

/// Objects of a rawlog, as any MRPT program streams them.
inline std::vector<Object> objectsOf(const fs::path& rawlog) {
  std::vector<Object> objects;
  mrpt::io::CFileGZInputStream stream(rawlog.string());
  auto archive = mrpt::serialization::archiveFrom(stream);
  while (!stream.checkEOF()) try {
      objects.push_back(archive.ReadObject());
    } catch (const mrpt::serialization::CExceptionEOF&) {
      break;
    }
  return objects;
}

/// All files under `folder` by their path in it, with their bytes.
inline std::map<std::string, std::string> filesIn(const fs::path& folder) {
  std::map<std::string, std::string> files;
  if (!fs::exists(folder)) return files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).string()] = readBytes(entry.path());
  return files;
}

/// Expects the same files with the same bytes, but for what was measured.
inline void expectSameFiles(const fs::path& a, const fs::path& b) {
  auto left = filesIn(a), right = filesIn(b);
  for (const char* measured : {"timings.csv", "resources.json"})
    left.erase(measured), right.erase(measured);
  ASSERT_FALSE(left.empty());
  for (const auto& [name, bytes] : left) EXPECT_TRUE(right.count(name)) << name;
  for (const auto& [name, bytes] : right) {
    ASSERT_TRUE(left.count(name)) << name;
    EXPECT_TRUE(left.at(name) == bytes) << name << " differs";
  }
}

/// Expects the same map, labels and tracks: what does not depend on the kind of the input.
inline void expectSameResult(const fs::path& a, const fs::path& b) {
  for (const char* name :
       {"static_map.ply", "static_map.metricmap", "moving_points.ply", "tracks.csv"}) {
    ASSERT_TRUE(fs::exists(a / name)) << name;
    EXPECT_TRUE(readBytes(a / name) == readBytes(b / name)) << name << " differs";
  }
  const auto labels = filesIn(a / "labels");
  EXPECT_FALSE(labels.empty());
  EXPECT_TRUE(labels == filesIn(b / "labels")) << "labels differ";
}

}  // namespace toss::test
