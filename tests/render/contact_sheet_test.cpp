// SPDX-License-Identifier: BSD-3-Clause
#include <toss/render/ContactSheet.h>

#include "RenderFixtures.h"

namespace toss::test {
namespace {

TEST(ContactSheetTest, PutsPicturesIntoAGrid) {
  const TemporaryFolder folder;
  const cv::Scalar colors[] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}};
  std::vector<SheetEntry> entries;
  for (int i = 0; i < 3; ++i) {
    const fs::path file = folder / (std::to_string(i) + ".png");
    cv::imwrite(file.string(), cv::Mat(100, 200, CV_8UC3, colors[i]));
    entries.push_back({file, std::string(i == 1 ? 300 : 5, 'W')});
  }
  writeContactSheet(entries, "A sheet", 2, 400, folder / "sheet.png");
  const cv::Mat sheet = cv::imread((folder / "sheet.png").string());
  const Blob blue = findBlob(sheet, [](const Color& c) { return isNear(c, {0, 0, 255}, 0); });
  const Blob green = findBlob(sheet, [](const Color& c) { return isNear(c, {0, 255, 0}, 0); });
  const Blob red = findBlob(sheet, [](const Color& c) { return isNear(c, {255, 0, 0}, 0); });
  for (const Blob& blob : {blue, green, red}) EXPECT_EQ(blob.pixels, 400u * 200u);
  EXPECT_EQ(blue.top, green.top);
  EXPECT_GT(green.left, blue.right);
  EXPECT_EQ(red.left, blue.left);
  EXPECT_GT(red.top, blue.bottom + 20);
  // The long caption stays under its picture.
  const cv::Mat captions = sheet.rowRange(green.bottom + 1, red.top);
  const Blob text = findBlob(captions, [](const Color& c) { return c.red < 120; });
  EXPECT_GE(text.left, blue.left);
  EXPECT_LE(text.right, green.right);
}

TEST(ContactSheetTest, NamesPicturesThatAreNone) {
  const TemporaryFolder folder;
  writeBytes(folder / "bad.png", "no picture");
  EXPECT_THAT(userErrorOf([&] {
                writeContactSheet({{folder / "bad.png", ""}}, "", 2, 100, folder / "s.png");
              }),
              ::testing::HasSubstr("bad.png"));
  EXPECT_NE(userErrorOf([&] { writeContactSheet({}, "", 2, 100, folder / "s.png"); }), "");
}

}  // namespace
}  // namespace toss::test
