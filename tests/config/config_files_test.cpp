// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace toss::test {
namespace {

namespace fs = std::filesystem;

struct ProgramResult {
  std::string output;
  int code = -1;
};

/// Runs `toss ARGUMENTS` and takes what it writes.
ProgramResult runProgram(const std::string& arguments) {
  ProgramResult result;
  std::FILE* pipe = ::popen(("'" TOSS_PROGRAM "' " + arguments + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return result;
  char buffer[4096];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof(buffer), pipe)) > 0;)
    result.output.append(buffer, n);
  result.code = ::pclose(pipe);
  return result;
}

std::string readText(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<fs::path> configurations() {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(TOSS_CONFIG_FOLDER))
    if (entry.path().extension() == ".ini") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string valuesOf(const std::string& text) {
  std::string values;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (text[begin] != '#' && end > begin) values += text.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return values;
}

class ConfigurationFile : public testing::TestWithParam<fs::path> {};

TEST_P(ConfigurationFile, IsUnderstoodToTheLastKey) {
  const ProgramResult result = runProgram("config --config '" + GetParam().string() + "'");
  EXPECT_EQ(result.code, 0) << result.output;
}

std::string testName(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, ConfigurationFile, testing::ValuesIn(configurations()), testName);

TEST(ConfigurationFiles, TossIniIsWhatTheProgramPrints) {
  const ProgramResult result = runProgram("config");
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_EQ(readText(fs::path(TOSS_CONFIG_FOLDER) / "toss.ini"), result.output)
      << "write it anew: toss config > config/toss.ini";
}

TEST(ConfigurationFiles, PaperAndAutoMosNameOnlyWhatDiffersFromTheDefaults) {
  const std::string defaults = valuesOf(runProgram("config").output);
  for (const char* name : {"paper.ini", "automos.ini"}) {
    std::string section;
    std::istringstream lines(valuesOf(readText(fs::path(TOSS_CONFIG_FOLDER) / name)));
    for (std::string line; std::getline(lines, line);) {
      if (line.front() == '[') section = line;
      const std::size_t begin = defaults.find(section);
      const std::string keys = defaults.substr(begin, defaults.find("\n[", begin) - begin) + "\n";
      EXPECT_TRUE(line == section || keys.find("\n" + line + "\n") == std::string::npos)
          << name << ": " << section << " " << line << " is the default already";
    }
  }
}

}  // namespace
}  // namespace toss::test
