// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <toss/geometry/OptionSections.h>

#include <limits>

namespace toss {
namespace {

enum class Color { Red, Green };

struct Sample : Options {
  double ratio = 0.1;
  int count = 3;
  bool on = true;
  Color color = Color::Red;
  std::string name = "a b";

  const char* section() const override { return "sample"; }
  void visit(OptionVisitor& v) override {
    v.real({"ratio", "m", "A ratio", "spec 1"}, ratio, 0.0, 1.0);
    v.integer({"count", "", "A count", "spec 1"}, count, 1, 10);
    v.flag({"on", "", "A switch", "spec 1"}, on);
    v.choice({"color", "", "A colour", "spec 1"}, color, {"red", "green"});
    v.string({"name", "", "A name", "spec 1"}, name);
  }
};

std::string errorOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(Options, TextReadsBackToTheSameBits) {
  Sample written, read;
  written.ratio = 1.0 / 3.0;
  written.count = 7;
  written.on = false;
  written.color = Color::Green;
  written.name = "some text";
  loadSectionsFromText(sectionsToText({&written}), "memory", {&read});
  EXPECT_EQ(written.ratio, read.ratio);
  EXPECT_EQ(written.count, read.count);
  EXPECT_EQ(written.on, read.on);
  EXPECT_EQ(written.color, read.color);
  EXPECT_EQ(written.name, read.name);
}

TEST(Options, AbsentKeysKeepTheirValue) {
  Sample sample;
  loadSectionsFromText("[sample]\ncount = 5\n", "memory", {&sample});
  EXPECT_EQ(5, sample.count);
  EXPECT_EQ(0.1, sample.ratio);
}

TEST(Options, MrptStyleCommentsBehindValuesAreAllowed) {
  Sample sample;
  loadSectionsFromText("[sample]\nratio = 0.5  // half\n", "memory", {&sample});
  EXPECT_EQ(0.5, sample.ratio);
}

TEST(Options, UnknownNamesAreAnsweredWithTheNearest) {
  Sample sample;
  const auto load = [&](const std::string& text) {
    return errorOf([&] { loadSectionsFromText(text, "my.ini", {&sample}); });
  };
  EXPECT_THAT(load("[sampel]\n"), testing::HasSubstr("did you mean 'sample'"));
  EXPECT_THAT(load("[sample]\ncuont = 3\n"), testing::HasSubstr("did you mean 'count'"));
  EXPECT_THAT(load("[sample]\n\ncuont = 3\n"), testing::HasSubstr("my.ini: line 3"));
}

TEST(Options, ValuesOutOfRangeNameTheBounds) {
  Sample sample;
  const auto set = [&](const std::string& text) {
    return errorOf([&] { setOption(text, {&sample}); });
  };
  EXPECT_THAT(set("sample.ratio=2"), testing::HasSubstr("from 0 to 1 m"));
  EXPECT_THAT(set("sample.ratio=nan"), testing::HasSubstr("from 0 to 1 m"));
  EXPECT_THAT(set("sample.count=3.5"), testing::HasSubstr("whole number from 1 to 10"));
  EXPECT_THAT(set("sample.on=perhaps"), testing::HasSubstr("true or false"));
  EXPECT_THAT(set("sample.color=blue"), testing::HasSubstr("red | green"));
  EXPECT_EQ(0.1, sample.ratio);
}

TEST(Options, LinesWithoutMeaningAreErrors) {
  Sample sample;
  const auto load = [&](const std::string& text) {
    return errorOf([&] { loadSectionsFromText(text, "my.ini", {&sample}); });
  };
  EXPECT_THAT(load("[sample]\nnonsense\n"), testing::HasSubstr("neither"));
  EXPECT_THAT(load("count = 1\n"), testing::HasSubstr("before any"));
  EXPECT_THAT(load("[sample]\ncount=1\ncount=2\n"), testing::HasSubstr("twice"));
  EXPECT_NE("", errorOf([&] { loadSections("/nowhere/at/all.ini", {&sample}); }));
  EXPECT_NE("", errorOf([&] { setOption("sample", {&sample}); }));
}

TEST(Options, CheckFindsValuesSetInCode) {
  Sample sample;
  EXPECT_NO_THROW(sample.check());
  sample.ratio = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(sample.check(), UserError);
  sample.ratio = 0.5;
  sample.count = 99;
  EXPECT_THROW(sample.check(), UserError);
}

}  // namespace
}  // namespace toss
