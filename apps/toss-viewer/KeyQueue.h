// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/gui/CBaseGUIWindow.h>
#include <mrpt/system/CObserver.h>

#include <mutex>
#include <utility>
#include <vector>

namespace toss {

/// The keys pressed in a window, in their order; the window itself remembers the last one only.
class KeyQueue : public mrpt::system::CObserver {
 public:
  explicit KeyQueue(mrpt::gui::CBaseGUIWindow& window) { observeBegin(window); }

  /// Keys since the last call.
  std::vector<int> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(keys_, {});
  }

 private:
  void OnEvent(const mrpt::system::mrptEvent& event) override {
    if (!event.isOfType<mrpt::gui::mrptEventWindowChar>()) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    keys_.push_back(event.getAs<mrpt::gui::mrptEventWindowChar>()->char_code);
  }

  std::mutex mutex_;
  std::vector<int> keys_;
};

}  // namespace toss
