// Steps and frames.
#include "run.h"

namespace weft_tests::driver {

using weft::Status;

double Run::time_step(Random& r, bool& is_bad) const {
  is_bad = r.chance(0.1);
  if (is_bad) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const double endless = std::numeric_limits<double>::infinity();
    return r.one_of({none, endless, -endless, -1e-9, -1.0, 5e-324, 1e-310});
  }
  if (is_extreme_ && r.chance(0.1))
    return r.one_of({1e-14, 1e-16, 1e-30, 1e-300, 10.0, 1e9, 1e300});
  return r.one_of({1.0 / 60, 1.0 / 60, 1.0 / 60, 1.0 / 120, 1.0 / 144, 0.001, 0.04, 0.0});
}

Status Run::afford(ModelWorld& w, double dt, double steps) {
  const weft::Result<uint32_t> count = w.world.substeps(dt);
  if (!count) return count.status();
  return *count * steps <= 200 ? Status::ok
                               : Status::unsupported;  // what no call of a step answers
}

/// Too long to be made: no call at all.
static Outcome not_made() { return {}; }

Outcome Run::step(Random& r, ModelWorld& w) {
  bool is_bad = false;
  const double dt = time_step(r, is_bad);
  if (!w.in_flight && !is_bad) {
    const Status way = afford(w, dt, 1);
    if (way == Status::unsupported) return not_made();
    if (way != Status::ok) {
      require(w.world.step(dt) == way, "substeps and step answer differently");
      return {way, Expect::any, 0};
    }
  }
  const Status status = w.world.step(dt);
  if (is_bad) return {status, Expect::refusal, 0};
  if (w.lost && dt > 0 && !w.in_flight) {
    require(status == Status::diverged || status == Status::out_of_memory,
            "a world that diverged answers %s", weft::to_string(status));
  }
  return {status, Expect::any, 0};
}

Outcome Run::advance(Random& r, ModelWorld& w) {
  bool is_bad = false;
  double dt = time_step(r, is_bad);
  if (r.chance(0.3)) dt *= r.real(0.5, 4);
  is_bad = !(std::isfinite(dt) && dt >= 0);
  if (!w.in_flight && !is_bad &&
      afford(w, w.desc.fixed_dt, w.desc.max_steps_per_advance) == Status::unsupported) {
    return not_made();
  }
  book_.clear();
  const double before = w.world.time();
  const weft::Result<weft::Advance> made = w.world.advance(dt);
  if (!made) return {made.status(), is_bad ? Expect::refusal : Expect::any, 0};
  require(made->steps <= w.desc.max_steps_per_advance, "advance took %u steps", made->steps);
  require(made->alpha >= 0 && made->alpha < 1, "alpha is %.17g", made->alpha);
  require((made->steps == 0) == (w.world.time() == before) || is_extreme_,
          "%u steps moved time from %.17g to %.17g s", made->steps, before, w.world.time());
  require(made->time <= w.world.time(), "what is drawn lies ahead");
  Digest digest;
  digest.add(made->steps);
  digest.add(made->alpha);
  digest.add(made->time);
  return {Status::ok, is_bad ? Expect::refusal : Expect::any, digest.value()};
}

Outcome Run::begin_step(Random& r, ModelWorld& w) {
  bool is_bad = false;
  const double dt = time_step(r, is_bad);
  if (!w.in_flight && !is_bad) {
    const Status way = afford(w, dt, 1);
    if (way == Status::unsupported) return not_made();
    book_.clear();
  }
  const double dropped = w.world.stats().time_dropped;
  const bool was_in_flight = w.in_flight;
  const Status status = w.world.begin_step(dt);
  if (status == Status::ok) {
    require(!was_in_flight, "a second step began");
    w.in_flight = true;
    w.flight_dropped = dropped;
  }
  return {status, is_bad ? Expect::refusal : Expect::any, 0};
}

Outcome Run::end_step(Random&, ModelWorld& w) {
  const bool was_in_flight = w.in_flight;
  const Status status = w.world.end_step();
  if (!was_in_flight) return {status, Expect::refusal, 0};
  w.in_flight = false;
  w.is_known = false;
  require(status == Status::ok || status == Status::diverged, "end_step answers %s",
          weft::to_string(status));
  return {status, Expect::any, 0};
}

Outcome Run::prepare(Random& r, ModelWorld& w) {
  bool is_bad = false;
  const double dt = time_step(r, is_bad);
  if (!w.in_flight && !is_bad && afford(w, dt, 1) == Status::unsupported) return not_made();
  book_.clear();
  return {w.world.prepare(dt), is_bad ? Expect::refusal : Expect::any, 0};
}

Outcome Run::substeps(Random& r, ModelWorld& w) {
  bool is_bad = false;
  const weft::Result<uint32_t> count = w.world.substeps(time_step(r, is_bad));
  Digest digest;
  digest.add(count ? *count : 0);
  if (count) require(*count >= 1, "no substep");
  return {count.status(), is_bad ? Expect::refusal : Expect::any, digest.value()};
}

}  // namespace weft_tests::driver
