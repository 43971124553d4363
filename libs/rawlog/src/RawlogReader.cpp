// SPDX-License-Identifier: BSD-3-Clause
#include "RawlogReader.h"

#include <mrpt/obs/CRawlog.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt/serialization/CArchive.h>
#include <toss/geometry/Error.h>

#include <algorithm>
#include <cctype>

#include "ObjectLengths.h"

namespace toss {
namespace {

constexpr const char* kCopyAgain =
    "copy or record the file again, or read only what lies before it with --to";

bool isClassNameLetter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == ':' || c == '<' ||
         c == '>' || c == ',' || c == ' ';
}

std::string firstLine(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \n");
  if (begin == std::string::npos) return "unknown fault";
  return text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace

RawlogReader::RawlogReader(const std::filesystem::path& file) : file_(file), stream_(file) {
  if (nextClassName().empty() && stream_.damage().empty())
    throw UserError(file.string(), "is not a rawlog: no MRPT object at its beginning",
                    "give a .rawlog file or a folder in KITTI layout");
}

std::string RawlogReader::place() const {
  return file_.string() + ": object " + std::to_string(count_ == 0 ? 0 : count_ - 1);
}

std::string RawlogReader::nextClassName() {
  // An object begins with the length of its class name, highest bit set, and the name.
  const std::string_view head = stream_.peek(128);
  if (head.empty()) return {};
  const auto first = static_cast<unsigned char>(head[0]);
  const std::string_view name = head.substr(1, first & 0x7fu);
  const bool plausible = (first & 0x80u) != 0 && !name.empty() &&
                         std::all_of(name.begin(), name.end(), isClassNameLetter);
  return plausible ? std::string(name) : std::string();
}

void RawlogReader::failInObject(const std::string& className, const std::string& detail) {
  const std::string where = file_.string() + ": object " + std::to_string(count_);
  const std::string what = className.empty() ? "" : " (" + className + ")";
  // Damage shows only once the stream has been read up to it; a header that is cut is still there.
  const bool cut = stream_.atEnd() || (className.empty() && detail.empty());
  if (!stream_.damage().empty()) throw UserError(where + what, stream_.damage(), kCopyAgain);
  if (cut) throw UserError(where + what, "the file is cut off in the middle of it", kCopyAgain);
  throw UserError(where + what, detail, kCopyAgain);
}

mrpt::serialization::CSerializable::Ptr RawlogReader::readObject() {
  if (stream_.atEnd()) {
    if (!stream_.damage().empty()) failInObject("", "");
    return nullptr;
  }
  const std::string className = nextClassName();
  if (className.empty())
    throw UserError(file_.string() + ": after object " + std::to_string(count_) + ", byte " +
                        std::to_string(stream_.getPosition()),
                    "something follows that is no MRPT object", kCopyAgain);
  if (className != "nullptr" && !mrpt::rtti::findRegisteredClass(className)) {
    const bool nameIsCut = stream_.peek(128).size() <= className.size() + 1;
    if (nameIsCut) failInObject("", "");
    throw UserError(file_.string() + ": object " + std::to_string(count_),
                    "is of class '" + className + "', which is not known here",
                    "remove these objects with the program that wrote them, nothing behind them "
                    "can be read");
  }
  const std::string impossible = impossibleLength(stream_.peek(4096), stream_.mostBytesLeft());
  if (!impossible.empty()) failInObject(className, impossible);
  try {
    auto object = mrpt::serialization::archiveFrom(stream_).ReadObject();
    ++count_;
    return object;
  } catch (const std::exception& error) {
    failInObject(className, "can't be read (" + firstLine(error.what()) + ")");
  }
}

mrpt::serialization::CSerializable::Ptr RawlogReader::next() {
  for (;;) {
    if (!unpacked_.empty()) {
      auto object = unpacked_.front();
      unpacked_.pop_front();
      return object;
    }
    const std::uint64_t before = count_;
    auto object = readObject();
    if (auto whole = std::dynamic_pointer_cast<mrpt::obs::CRawlog>(object))
      for (std::size_t i = 0; i < whole->size(); ++i) unpacked_.push_back(whole->getAsGeneric(i));
    else if (object || count_ == before)
      return object;
  }
}

}  // namespace toss
