// What is checked of events, sleepers and memory.
#include "run.h"

#include <algorithm>

namespace weft_tests::driver {

using weft::EventType;
using weft::Status;

static uint64_t digest_of(weft::View<weft::Event> events) {
  Digest digest;
  for (uint32_t i = 0; i < events.count; ++i) {
    const weft::Event& e = events[i];
    digest.add(int(e.type));
    digest.add(e.cloth.index);
    digest.add(e.vertex);
    digest.add(e.time);
  }
  return digest.value();
}

/// Sleep and waking take turns, time that is dropped has an event, and what is no step keeps the
/// events of the last.
void Run::check_events(ModelWorld& w, const Call& call, const Outcome& outcome, double dropped) {
  const weft::View<weft::Event> events = w.world.events();
  const uint64_t seen = digest_of(events);
  const bool failed = outcome.status != Status::ok;
  if (!(call.traits & time_passes)) {
    require(seen == w.seen_events, "%s changed the events of the last step", call.name);
    return;
  }
  // A step of no length keeps the events of the last, of cloths that may have gone since.
  const bool is_new = seen != w.seen_events || w.world.stats().frames != w.seen_frames;
  w.seen_events = seen;
  w.seen_frames = w.world.stats().frames;
  if (!is_new) return;
  if (w.in_flight || w.lost || (failed && outcome.status != Status::diverged)) return;
  bool tells_dropped = false, tells_not_finite = false;
  for (uint32_t i = 0; i < events.count; ++i) {
    const weft::Event& e = events[i];
    require(e.text && e.text[0], "an event without a text");
    require(std::strcmp(weft::to_string(e.type), "unknown") != 0, "an event of type %d",
            int(e.type));
    require(e.time <= w.world.time(), "an event at %.9g s, now is %.9g s", e.time, w.world.time());
    tells_dropped |= e.type == EventType::time_dropped;
    tells_not_finite |= e.type == EventType::non_finite || e.type == EventType::force_overflow;
    if (!e.cloth) continue;
    ModelCloth* cloth = nullptr;
    for (ModelCloth& c : w.cloths) {
      if (c.id == e.cloth) cloth = &c;
    }
    require(cloth != nullptr, "an event of a cloth that is not there");
    require(e.vertex < cloth->vertices, "an event of vertex %u of %u", e.vertex, cloth->vertices);
    if (e.type != EventType::slept && e.type != EventType::woke) continue;
    require(cloth->told_asleep == (e.type == EventType::woke), "a cloth %s twice",
            weft::to_string(e.type));
    cloth->told_asleep = e.type == EventType::slept;
  }
  const double before = call.make == &Run::end_step ? w.flight_dropped : dropped;
  if (!failed) {
    require(tells_dropped == (w.world.stats().time_dropped > before) || is_extreme_,
            "time was dropped: %.9g s, of which an event tells: %d",
            w.world.stats().time_dropped - before, int(tells_dropped));
  } else if (!w.lost) {
    require(tells_not_finite, "diverged without an event");
    w.lost = true;
  }
}

void Run::remember_places(const ModelWorld& w) {
  places_.clear();
  if (!w.is_known || w.in_flight) return;
  for (const ModelCloth& cloth : w.cloths) {
    places_.push_back({cloth.id, cloth.seen_positions, cloth.seen_asleep});
  }
}

/// Only time moves vertices, and not those of who slept before and after it without a word.
void Run::check_places(const ModelWorld& w, const Call& call) const {
  if (w.in_flight) return;
  for (const ModelCloth& cloth : w.cloths) {
    const auto before = std::find_if(places_.begin(), places_.end(),
                                     [&](const Place& p) { return p.cloth == cloth.id; });
    if (before == places_.end() || before->positions == cloth.seen_positions) continue;
    // In a world that has stepped, a new pin with a motion begins where its motion is by now.
    require((call.traits & time_passes) || cloth.has_motions, "%s moved a vertex", call.name);
    bool woke = false;
    const weft::View<weft::Event> events = w.world.events();
    for (uint32_t i = 0; i < events.count; ++i) woke |= events[i].cloth == cloth.id;
    require(woke || !before->asleep || !cloth.seen_asleep, "a sleeping cloth moved");
  }
}

void Run::check_memory() const {
  for (const auto& home : homes_) {
    if (const char* fault = home->heap.fault()) throw Finding(fault);
  }
  if (pool_.fault()) throw Finding(pool_.fault());
  for (const auto& w : worlds_) {
    for (const ModelOutput& output : w->outputs) {
      if (!output.memory) continue;
      require(*output.memory == *output.copy, "the memory of an output was written");
    }
  }
}

void Run::finish() {
  worlds_.clear();
  for (const auto& home : homes_) {
    home->fabrics.clear();
    home->meshes.clear();
    require(home->context.bytes_allocated() == home->bytes_alone, "%llu bytes are held of nothing",
            static_cast<unsigned long long>(home->context.bytes_allocated() - home->bytes_alone));
    home->context = weft::Context();
    require(home->heap.blocks() == 0, "%zu blocks of memory are left", home->heap.blocks());
  }
  check_memory();
}

std::string Run::last_calls(size_t count) const {
  std::string lines;
  for (size_t i = told_.size() - std::min(count, told_.size()); i < told_.size(); ++i) {
    lines += told_[i] + "\n";
  }
  return lines;
}

}  // namespace weft_tests::driver
