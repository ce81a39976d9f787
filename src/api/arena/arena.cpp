#include "api/arena/arena.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "api/arena/fill.h"
#include "api/arena/collider_inputs.h"
#include "api/arena/colours.h"
#include "api/arena/contact_frame.h"
#include "api/arena/contacts.h"
#include "api/arena/device_memory.h"
#include "api/arena/origins.h"
#include "api/arena/overflow.h"
#include "api/arena/parts.h"
#include "api/arena/pin_inputs.h"
#include "api/arena/probe.h"
#include "api/arena/spring_watcher.h"
#include "api/arena/survey.h"
#include "api/arena/vectors.h"

namespace weft::api {

namespace {

template <class T>
class ArenaOf final : public Arena, public HostObject {
 public:
  explicit ArenaOf(ContextState& context)
      : context_(context),
        backend_(*context.backend),
        memory_(context),
        contacts_(context),
        colliders_(backend_),
        pins_(backend_) {}

  Status build(const ArenaInput& in, double dt, double time, Workers workers) override {
    memory_.release();
    device_ = {};
    Status status = memory_.allocate(plan::device_bytes(in.shape, stride()));
    if (status != Status::ok) return status;
    device_ = plan::cut<T>(in.shape, stride(), memory_.data());
    sim_ = device_.sim;
    set_ranges(plan::compile_plan(in.shape));
    sim_.coloured.table = colours_.emplace(in).table();
    const Vector<ClothCounts> places = plan::places_of(in.shape);
    for (size_t c = 0; c < in.cloths.size(); ++c) {
      in.cloths[c]->place = places[c];
      in.cloths[c]->settling = substeps_to_settle;
      in.cloths[c]->parts_changed = 0;
    }
    status = fill(in, dt, time);
    if (status == Status::ok) status = contacts_.prepare(in, sim_);
    if (status != Status::ok) return status;
    params_.resize(in.cloths.size());
    found_.resize(static_cast<size_t>(places.back().survey_groups));
    status = upload_params(in);
    if (status != Status::ok) return status;
    Frame<T> frame = make_frame(in, {1, dt, dt, time, workers});
    frame.sim.activity = nullptr;  // nobody sleeps through these
    if (any_starts(in) && !in.shape.projects && in.world->start != Start::lagged) {
      status = backend_.start(frame);
      sim_ = frame.sim;
      sim_.activity = device_.sim.activity;
      if (status != Status::ok) return status;
    }
    status = backend_.survey(frame);
    return status == Status::ok ? read_survey(in) : status;
  }

  Status frame(const ArenaInput& in, const FrameInput& input) override {
    Status status = colliders_.upload(in, input, device_);
    if (status == Status::ok) status = pins_.upload(in, input, device_.sim.pins);
    if (status == Status::ok) status = upload_parts(in);
    if (status == Status::ok) status = contacts_.upload(in, sim_);
    if (status == Status::ok && device_.before.data) {
      status = copy_vectors(backend_, sim_.x[0], device_.before, sim_.blocks);
    }
    if (status != Status::ok) return status;
    Frame<T> frame = make_frame(in, input);
    frame.by_block = colliders_.by_block();
    status = sim_.contacts.state ? frame_with_contact(backend_, contacts_, frame)
                                 : backend_.frame(frame);
    sim_ = frame.sim;
    if (status == Status::ok) status = contacts_.wake_touched(in, sim_);
    for (ClothRecord* cloth : in.cloths) {
      cloth->settling = std::max(0, cloth->settling - input.substeps);
    }
    if (status == Status::ok) status = read_survey(in);
    if (status != Status::ok) return status;
    const Vec3Array<T> none{};
    const Vec3Array<T> positions[] = {sim_.x[0], position_form_ ? sim_.x[2] : none, device_.before};
    return follow_cloths(backend_, in, positions, input.workers);
  }

  Status watch_stretch(const ArenaInput& in) override {
    const Vec3Array<T>* on_host = backend_.info().host_memory ? &sim_.x[0] : nullptr;
    const auto fetched = [&](const ClothRecord& cloth, Vector<Vec3<T>>& out) {
      return fetch(sim_.x[0], cloth.first(), cloth.cooked().vertices, out);
    };
    return springs_.look(in, on_host, size_t(stride()), fetched);
  }

  Status probe(const ArenaInput& in, const FrameInput& input) override {
    Status status = colliders_.upload(in, input, device_);
    if (status == Status::ok) status = pins_.upload(in, input, device_.sim.pins);
    if (status != Status::ok) return status;
    for (bool wanted = true; wanted && status == Status::ok;) {
      Frame<T> frame = make_frame(in, input);
      frame.by_block = colliders_.by_block();
      contacts_.forget_list();
      status = probe_.run(context_, frame, [&](const Vec3Array<T>& from, Vector<Vec3<T>>& out) {
        return fetch(from, 0, size_t(sim_.blocks) * block_size, out);
      });
      if (status == Status::ok) status = contacts_.make_room(sim_, wanted);
    }
    return status;
  }
  Status read_probe(const ClothRecord& cloth, Vector<Probed>& out) override {
    Vector<Vec3<T>> now;
    const Status status = fetch(sim_.x[0], cloth.first(), cloth.cooked().vertices, now);
    if (status == Status::ok) probe_.read(cloth, position_form_ ? now.data() : nullptr, out);
    return status;
  }

  Status normals(const ArenaInput& in, Workers workers) override {
    unsettle(in);
    Frame<T> frame{};
    frame.sim = sim_;
    frame.workers = workers;
    frame.position_form = position_form_;
    return backend_.normals(frame);
  }

  Status accelerations(const ArenaInput& in, double dt, double dt_before,
                       Workers workers) override {
    if (const Status status = upload_parts(in); status != Status::ok) return status;
    Frame<T> frame{};
    frame.sim = sim_;
    frame.workers = workers;
    frame.substeps = 1;
    frame.position_form = position_form_;
    frame.newcomers = any_starts(in);
    frame.dt = frame.newcomers ? dt : dt_before;
    frame.dt_before = dt_before;
    frame.gravity = narrow<T>(in.world->gravity);
    frame.wind = wind_of(in);
    frame.sim.activity = nullptr;
    unsettle(in);
    return backend_.accelerations(frame);
  }

  Status read(const ClothRecord& cloth, StateArray which, Vector<double3>& out) override {
    const uint32_t vertices = cloth.cooked().vertices;
    out.resize(vertices);
    Vector<Vec3<T>> now, before;
    const bool difference = which == StateArray::displacement && position_form_;
    Status status =
        fetch(which == StateArray::acceleration || which == StateArray::normal ? sim_.x[1]
              : which == StateArray::displacement && !position_form_           ? sim_.d[0]
                                                                               : sim_.x[0],
              cloth.first(), vertices, now);
    if (status == Status::ok && difference)
      status = fetch(sim_.x[2], cloth.first(), vertices, before);
    if (status != Status::ok) return status;
    for (uint32_t v = 0; v < vertices; ++v) {
      const uint32_t s = cloth.cooked().storage(v);
      out[v] = {now[s].x, now[s].y, now[s].z};
      if (difference) out[v] = minus(out[v], {before[s].x, before[s].y, before[s].z});
    }
    return Status::ok;
  }

  Status write(const ClothRecord& cloth, const VertexTarget& target, Workers workers) override {
    const scene::CookedFabric& fabric = cloth.cooked();
    if (fabric.vertices == 0) return Status::ok;
    VertexJob<T> job{};
    job.vertices = static_cast<int>(fabric.render_vertices());
    job.storage = fabric.render_storage();
    job.alpha = static_cast<T>(device_.before.data ? target.alpha : 1);
    job.shift = {target.shift.x, target.shift.y, target.shift.z};
    job.last = target.last;
    job.out_position = target.position;
    job.out_normal = target.normal;
    job.out_last = target.last_position;
    Vector<T> mirrors[3];
    Status status = on_host(context_, sim_.x[0], cloth, mirrors[0], job.now);
    if (status == Status::ok && job.alpha != T(1)) {
      status = on_host(context_, device_.before, cloth, mirrors[1], job.before);
    }
    if (status == Status::ok && target.normal.format != VertexFormat::none) {
      status = on_host(context_, sim_.x[1], cloth, mirrors[2], job.normal);
    }
    return status == Status::ok ? context_.host().write_vertices(job, workers) : status;
  }

  Status save(const ArenaInput& in) override {
    Vector<Vec3<T>> values;
    for (ClothRecord* cloth : in.cloths) {
      if (!cloth->moved || cloth->buried) continue;
      if (device_.before.data) {
        const size_t vertices = cloth->cooked().vertices;
        const Status status = fetch(device_.before, cloth->first(), vertices, values);
        if (status != Status::ok) return status;
        cloth->saved_before.assign(vertices, {0, 0, 0});
        for (size_t i = 0; i < vertices; ++i) {
          cloth->saved_before[i] = {values[i].x, values[i].y, values[i].z};
        }
      }
      for (const bool position : {true, false}) {
        const Vec3Array<T> from = position ? sim_.x[0] : position_form_ ? sim_.x[2] : sim_.d[0];
        const Status status = fetch(from, cloth->first(), cloth->cooked().vertices, values);
        if (status != Status::ok) return status;
        Vector<double3>& to = position ? cloth->saved_x : cloth->saved_d;
        to.resize(values.size());
        for (size_t i = 0; i < values.size(); ++i) to[i] = {values[i].x, values[i].y, values[i].z};
      }
    }
    return Status::ok;
  }

  Status force_overflow(ForceOverflow& found) override {
    return find_overflow(backend_, device_.sim.edges, found);
  }

  Status near_pairs(const ArenaInput& in, bool with_excluded, Workers workers,
                    Vector<NearPair>& out) override {
    if (!sim_.contacts.state) return Status::ok;
    Status status = contacts_.upload(in, sim_);
    for (bool wanted = true; wanted && status == Status::ok;) {
      Frame<T> frame{};
      frame.sim = sim_;
      frame.sim.contacts.with_excluded = with_excluded ? 1 : 0;
      frame.workers = workers;
      frame.position_form = in.world->form == Form::position;
      contacts_.forget_list();
      status = backend_.pairs(frame);
      if (status == Status::ok) status = contacts_.make_room(sim_, wanted);
    }
    Vector<Vec3<T>> x;
    if (status == Status::ok) status = fetch(sim_.x[0], 0, size_t(sim_.blocks) * block_size, x);
    if (status != Status::ok) return status;
    return contacts_.near_pairs(in, sim_, x, with_excluded, out);
  }
  void list_counts(uint64_t& lists, uint64_t& listed) const override {
    contacts_.counts(lists, listed);
  }

  uint64_t bytes() const override { return device_.bytes + contacts_.bytes(); }
  uint64_t list_bytes() const override { return contacts_.bytes(); }

 private:
  int stride() const { return backend_.info().vector_stride; }

  void set_ranges(const plan::Plan& plan) {
    for (const BlockRange& range : plan.ranges) sim_.ranges[sim_.range_count++] = range;
  }

  /// Writes the state of the records to the device, through an image where the host cannot reach
  /// it.
  Status fill(const ArenaInput& in, double dt, double time) {
    if (backend_.info().host_memory) {
      std::memset(memory_.data(), 0, memory_.bytes());
      fill_at(in, dt, time, device_);
      return Status::ok;
    }
    const size_t bytes = memory_.bytes();
    Vector<char> memory(bytes + 128);
    void* base = memory.data();
    size_t room = memory.size();
    char* image = static_cast<char*>(std::align(128, bytes, base, room));
    plan::DeviceArrays<T> arrays = plan::cut<T>(in.shape, stride(), image);
    fill_at(in, dt, time, arrays);
    return backend_.to_device(memory_.data(), image, bytes);
  }
  void fill_at(const ArenaInput& in, double dt, double time, plan::DeviceArrays<T>& image) {
    fill_image<T>(in, stride(), dt, time, image);
    contacts_.fill(in, image.sim);
    colliders_.prepare(in, image);
    pins_.prepare(in, image.sim.pins);
  }

  static bool any_starts(const ArenaInput& in) {
    return std::any_of(in.cloths.begin(), in.cloths.end(), [](auto* c) { return !c->moved; });
  }

  Frame<T> make_frame(const ArenaInput& in, const FrameInput& input) {
    Frame<T> frame{};
    frame.sim = sim_;
    frame.substeps = input.substeps;
    frame.position_form = position_form_;
    frame.dt = input.dt;
    frame.dt_before = input.dt_before;
    frame.newcomers = any_starts(in);
    frame.gravity = narrow<T>(in.world->gravity);
    frame.wind = wind_of(in);
    frame.workers = input.workers;
    return frame;
  }

  /// What lies in x[1] is overwritten: sleepers must put their state there again.
  static void unsettle(const ArenaInput& in) {
    for (ClothRecord* cloth : in.cloths) cloth->settling = substeps_to_settle;
  }

  static Wind<T> wind_of(const ArenaInput& in) {
    if (!in.wind) return {};
    return {narrow<T>(in.wind->velocity),
            static_cast<T>(in.wind->air_density * in.wind->normal / 12),
            static_cast<T>(in.wind->air_density * in.wind->tangential / 12)};
  }

  Status read_survey(const ArenaInput& in) {
    if (found_.empty()) return Status::ok;
    const Status status =
        backend_.to_host(found_.data(), sim_.survey, found_.size() * sizeof(Survey<T>));
    if (status == Status::ok) take_survey(in, found_);
    return status;
  }

  /// Parts that have changed, into room that is there already.
  Status upload_parts(const ArenaInput& in) {
    for (ClothRecord* cloth : in.cloths) {
      if (cloth->parts_changed == 0) continue;
      Status status = Status::ok;
      Parts::each([&](auto part) {
        const bool changed = (cloth->parts_changed >> index_of(part.part) & 1u) != 0;
        if (changed && part.used(*cloth) && status == Status::ok) status = upload(part, *cloth);
      });
      if (status != Status::ok) return status;
      cloth->parts_changed = 0;
    }
    return Status::ok;
  }
  template <class ThePart>
  Status upload(ThePart part, const ClothRecord& cloth) {
    const int64_t elements = int64_t(slices_of(cloth)) * block_size;
    const int64_t first = cloth.place.part[index_of(part.part)];
    const auto to = pieces_of(part, sim_, first, elements, stride());
    if (backend_.info().host_memory) {  // in place: a step takes no memory
      for (const Piece& piece : to) std::memset(piece.at, 0, piece.bytes);
      part.fill(cloth, first, stride(), part.arrays(sim_));
      return Status::ok;
    }
    const Counts counts = counts_with(part.part, elements);
    const auto cut = [&](char* base, Simulation<T>& image) {
      plan::Cutter cutter(base, static_cast<size_t>(stride()));
      cutter.group(part.arrays(image), counts);
      return cutter.bytes();
    };
    Simulation<T> image{};
    Vector<char> memory(cut(nullptr, image));
    cut(memory.data(), image);
    part.fill(cloth, 0, stride(), part.arrays(image));
    const auto from = pieces_of(part, image, 0, elements, stride());
    for (int k = 0; k < from.count; ++k) {
      const Status status = backend_.to_device(to.at[k].at, from.at[k].at, from.at[k].bytes);
      if (status != Status::ok) return status;
    }
    return Status::ok;
  }

  /// Parameters of the cloths; those that have moved since the last upload no longer start.
  Status upload_params(const ArenaInput& in) {
    position_form_ = in.world->form == Form::position;
    fill_params(in, params_);
    sim_.windy = std::any_of(params_.begin(), params_.end(), [](auto& p) { return p.in_wind; });
    if (params_.empty()) return Status::ok;
    return backend_.to_device(writable(sim_.cloths), params_.data(),
                              params_.size() * sizeof(ClothParams<T>));
  }

  Status fetch(const Vec3Array<T>& from, int first, size_t count, Vector<Vec3<T>>& out) {
    return fetch_vectors(backend_, from, first, count, out);
  }

  ContextState& context_;
  const Backend& backend_;
  DeviceMemory memory_;
  plan::DeviceArrays<T> device_;  ///< as they were cut
  Simulation<T> sim_{};           ///< as the last frame left them: which buffer holds the present
  bool position_form_ = false;
  std::optional<ColourStarts> colours_;  ///< Simulation::coloured points to it
  Vector<ClothParams<T>> params_;
  Vector<Survey<T>> found_;
  SpringWatcher<T> springs_;
  Probe<T> probe_;
  ContactTables<T> contacts_;
  ColliderInputs<T> colliders_;
  PinInputs<T> pins_;
};

}  // namespace

std::unique_ptr<Arena> make_arena(Precision precision, ContextState& context) {
  if (precision == Precision::float64) return std::make_unique<ArenaOf<double>>(context);
  return std::make_unique<ArenaOf<float>>(context);
}

}  // namespace weft::api
