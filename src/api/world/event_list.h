// Events of a step: room is made before it, so that telling of it needs no memory.
#pragma once

#include "base/host_memory.h"
#include "base/message_host.h"
#include "weft/world.hpp"

namespace weft::api {

class EventList {
 public:
  /// For `count` more. Throws std::bad_alloc.
  void make_room(size_t count) {
    const size_t wanted = events_.size() + count;
    if (wanted > events_.capacity()) events_.reserve(wanted + wanted / 2);
  }
  /// `text` must outlive the list. Where no room was made, the last event makes some.
  void push_back(const Event& event) noexcept {
    if (events_.size() == events_.capacity()) {
      if (events_.empty()) return;
      events_.pop_back();
    }
    events_.push_back(event);
  }
  /// An event whose text is kept here, as long as there is room for it.
  void push_back(const Event& event, const Text& words) noexcept {
    Event told = event;
    told.text = "as the events before it: of its text there was no room left";
    if (texts_used_ < text_count) {
      texts_[texts_used_] = words;
      told.text = texts_[texts_used_++].c_str();
    }
    push_back(told);
  }
  void clear() noexcept {
    events_.clear();
    texts_used_ = 0;
  }
  View<Event> view() const noexcept { return {events_.data(), events_.size()}; }

 private:
  static constexpr size_t text_count = 16;
  Vector<Event> events_;
  Text texts_[text_count];
  size_t texts_used_ = 0;
};

}  // namespace weft::api
