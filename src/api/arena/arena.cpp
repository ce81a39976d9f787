#include "api/arena/arena.h"

#include <algorithm>
#include <cstring>

#include "api/arena/fill.h"
#include "api/arena/arena_views.h"
#include "api/arena/collider_inputs.h"
#include "api/arena/pin_inputs.h"
#include "api/arena/survey.h"

namespace weft::api {

namespace {

template <class T>
class ArenaOf final : public Arena {
 public:
  explicit ArenaOf(ContextState& context)
      : context_(context), backend_(*context.backend), colliders_(backend_), pins_(backend_) {}
  ~ArenaOf() override { release(); }

  Status build(const ArenaInput& in, double dt_before, double time, Workers workers) override {
    release();
    plan_ = plan::compile_plan(in.shape);
    layout_ = plan::lay_out(in.shape, step());
    Status status = allocate();
    if (status != Status::ok) return status;
    sim_ = views_of<T>(layout_, plan_, in.shape, memory_);
    before_ = {nullptr, 0};
    if (layout_.before.offset != plan::absent) {
      before_ = {at<T>(layout_.before.offset), layout_.before.pitch};
    }

    std::vector<char> mirror;  // where the device is not the host's own memory
    char* image = memory_;
    if (!backend_.info().host_memory) {
      mirror.resize(layout_.bytes);
      image = mirror.data();
    } else {
      std::memset(memory_, 0, layout_.bytes);
    }
    fill_image<T>(in, layout_, step(), dt_before, time, image);
    fill_survey_ranges(in, layout_, image);
    colliders_.prepare(in, layout_, image);
    pins_.prepare(in, layout_, image);
    if (!mirror.empty()) status = backend_.to_device(memory_, image, layout_.bytes);
    if (status != Status::ok) return status;

    params_.resize(in.cloths.size());
    found_.resize(in.shape.survey_groups());
    for (ClothRecord* cloth : in.cloths) {
      cloth->settling = substeps_to_settle;
      cloth->forces_changed = false;
    }
    status = upload_params(in);
    if (status != Status::ok) return status;
    Frame<T> frame = make_frame(in, {1, dt_before, dt_before, time, workers});
    frame.sim.activity = nullptr;  // nobody sleeps through these
    const bool any =
        std::any_of(in.cloths.begin(), in.cloths.end(), [](auto* c) { return !c->moved; });
    if (any && in.world->start != Start::lagged) {
      status = backend_.start(frame);
      sim_ = frame.sim;
      sim_.activity = views_of<T>(layout_, plan_, in.shape, memory_).activity;
      if (status != Status::ok) return status;
    }
    status = backend_.survey(frame);
    return status == Status::ok ? read_survey(in) : status;
  }

  Status frame(const ArenaInput& in, const FrameInput& input) override {
    Status status = colliders_.upload(in, input, layout_, memory_);
    if (status == Status::ok) status = pins_.upload(in, input, layout_, memory_);
    if (status == Status::ok) status = upload_forces(in);
    if (status != Status::ok) return status;
    if (before_.data) status = remember_positions();
    if (status != Status::ok) return status;
    Frame<T> frame = make_frame(in, input);
    frame.by_block = colliders_.by_block();
    status = backend_.frame(frame);
    sim_ = frame.sim;
    for (ClothRecord* cloth : in.cloths) {
      cloth->settling = std::max(0, cloth->settling - input.substeps);
    }
    return status == Status::ok ? read_survey(in) : status;
  }

  Status normals(const ArenaInput& in, Workers workers) override {
    unsettle(in);
    Frame<T> frame{};
    frame.sim = sim_;
    frame.workers = workers;
    frame.position_form = position_form_;
    return backend_.normals(frame);
  }

  Status accelerations(const ArenaInput& in, double dt_before, Workers workers) override {
    Frame<T> frame{};
    frame.sim = sim_;
    frame.workers = workers;
    frame.substeps = 1;
    frame.position_form = position_form_;
    frame.dt = frame.dt_before = dt_before;
    frame.gravity = narrow<T>(in.world->gravity);
    frame.wind = wind_of(in);
    frame.sim.activity = nullptr;
    unsettle(in);
    return backend_.accelerations(frame);
  }

  Status read(const ClothRecord& cloth, StateArray which, std::vector<double3>& out) override {
    const uint32_t vertices = cloth.cooked().vertices;
    out.resize(vertices);
    std::vector<Vec3<T>> now, before;
    const bool difference = which == StateArray::displacement && position_form_;
    Status status =
        fetch(which == StateArray::acceleration || which == StateArray::normal ? sim_.x[1]
              : which == StateArray::displacement && !position_form_           ? sim_.d[0]
                                                                               : sim_.x[0],
              cloth.first, vertices, now);
    if (status == Status::ok && difference)
      status = fetch(sim_.x[2], cloth.first, vertices, before);
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
    job.alpha = static_cast<T>(before_.data ? target.alpha : 1);
    job.shift = {target.shift.x, target.shift.y, target.shift.z};
    job.last = target.last;
    job.out_position = target.position;
    job.out_normal = target.normal;
    job.out_last = target.last_position;
    std::vector<T> mirrors[3];
    Status status = on_host(sim_.x[0], cloth, mirrors[0], job.now);
    if (status == Status::ok && job.alpha != T(1)) {
      status = on_host(before_, cloth, mirrors[1], job.before);
    }
    if (status == Status::ok && target.normal.format != VertexFormat::none) {
      status = on_host(sim_.x[1], cloth, mirrors[2], job.normal);
    }
    return status == Status::ok ? context_.host().write_vertices(job, workers) : status;
  }

  Status save(const ArenaInput& in) override {
    std::vector<Vec3<T>> values;
    for (ClothRecord* cloth : in.cloths) {
      if (!cloth->moved) continue;
      if (before_.data) {
        const size_t vertices = cloth->cooked().vertices;
        const Status status = fetch(before_, cloth->first, vertices, values);
        if (status != Status::ok) return status;
        cloth->saved_before.assign(vertices, {0, 0, 0});
        for (size_t i = 0; i < vertices; ++i) {
          cloth->saved_before[i] = {values[i].x, values[i].y, values[i].z};
        }
      }
      for (const bool position : {true, false}) {
        const Vec3Array<T> from = position ? sim_.x[0] : position_form_ ? sim_.x[2] : sim_.d[0];
        const Status status = fetch(from, cloth->first, cloth->cooked().vertices, values);
        if (status != Status::ok) return status;
        std::vector<double3>& to = position ? cloth->saved_x : cloth->saved_d;
        to.resize(values.size());
        for (size_t i = 0; i < values.size(); ++i) to[i] = {values[i].x, values[i].y, values[i].z};
      }
    }
    return Status::ok;
  }

  Status force_overflow(ForceOverflow& found) override {
    found = {};
    if (layout_.edges.overflow == plan::absent) return Status::ok;
    unsigned long long key = no_overflow;
    Status status =
        backend_.to_host(&key, at<unsigned long long>(layout_.edges.overflow), sizeof key);
    if (status != Status::ok || key == no_overflow) return status;
    found.happened = true;
    found.substep = static_cast<int>(key >> 32);
    const auto e = static_cast<size_t>(key & 0xffffffffu);
    T stiffness{}, rest{};
    status = backend_.to_host(&found.a, at<int32_t>(layout_.edges.a) + e, sizeof found.a);
    if (status == Status::ok) {
      status = backend_.to_host(&found.b, at<int32_t>(layout_.edges.b) + e, sizeof found.b);
    }
    if (status == Status::ok) {
      status = backend_.to_host(&stiffness, at<T>(layout_.edges.stiffness) + e, sizeof stiffness);
    }
    if (status == Status::ok) {
      status = backend_.to_host(&rest, at<T>(layout_.edges.rest) + e, sizeof rest);
    }
    found.stiffness = static_cast<double>(stiffness);
    found.rest = static_cast<double>(rest);
    return status;
  }

  uint64_t bytes() const override { return layout_.bytes; }

 private:
  int step() const { return backend_.info().particle_step; }
  template <class E>
  E* at(size_t offset) const {
    return reinterpret_cast<E*>(memory_ + offset);
  }

  Status allocate() {
    memory_ = static_cast<char*>(backend_.allocate(context_.memory.hooks(), layout_.bytes));
    if (!memory_) {
      const size_t wanted = layout_.bytes;
      layout_.bytes = 0;
      return context_.fail(
          Status::out_of_memory,
          text("no %zu bytes of device memory (the scene needs them) make it smaller", wanted));
    }
    if (!backend_.info().host_memory)
      context_.memory.count(static_cast<std::ptrdiff_t>(layout_.bytes));
    return Status::ok;
  }
  void release() {
    if (!memory_) return;
    backend_.release(context_.memory.hooks(), memory_, layout_.bytes);
    if (!backend_.info().host_memory)
      context_.memory.count(-static_cast<std::ptrdiff_t>(layout_.bytes));
    memory_ = nullptr;
  }

  Frame<T> make_frame(const ArenaInput& in, const FrameInput& input) {
    position_form_ = in.world->form == Form::position;
    Frame<T> frame{};
    frame.sim = sim_;
    frame.substeps = input.substeps;
    frame.position_form = position_form_;
    frame.dt = input.dt;
    frame.dt_before = input.dt_before;
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
    const Status status = backend_.to_host(found_.data(), at<Survey<T>>(layout_.survey),
                                           found_.size() * sizeof(Survey<T>));
    if (status == Status::ok) take_survey(in, found_);
    return status;
  }

  /// The positions before a frame, for outputs that lie between it and the next.
  Status remember_positions() {
    const auto elements = static_cast<size_t>(sim_.blocks) * block_size;
    if (step() > 1) {
      return backend_.copy(before_.data, sim_.x[0].data,
                           elements * static_cast<size_t>(step()) * sizeof(T));
    }
    Status status = Status::ok;
    for (size_t c = 0; c < 3 && status == Status::ok; ++c) {
      status = backend_.copy(before_.data + c * before_.pitch, sim_.x[0].data + c * sim_.x[0].pitch,
                             elements * sizeof(T));
    }
    return status;
  }

  /// An array of vectors from the cloth's first element on, where the host can read it.
  Status on_host(const Vec3Array<T>& from, const ClothRecord& cloth, std::vector<T>& mirror,
                 Vec3Array<T>& out) {
    if (backend_.info().host_memory) {
      out = {from.data + int64_t(cloth.first) * step(), from.pitch};
      return Status::ok;
    }
    std::vector<Vec3<T>> values;
    const size_t count = cloth.cooked().vertices;
    const Status status = fetch(from, cloth.first, count, values);
    if (status != Status::ok) return status;
    out = arranged(values, static_cast<size_t>(context_.host().info().particle_step), mirror);
    return Status::ok;
  }

  /// Forces that have changed, into room that is there already.
  Status upload_forces(const ArenaInput& in) {
    int first = 0;
    for (ClothRecord* cloth : in.cloths) {
      if (cloth->forces.empty()) continue;
      const int elements =
          static_cast<int>((cloth->cooked().vertices + block_size - 1) / block_size) * block_size;
      if (cloth->forces_changed) {
        std::vector<Vec3<T>> values(size_t(elements), Vec3<T>{0, 0, 0});
        for (const VertexForce& f : cloth->forces) {
          values[cloth->cooked().storage(f.vertex)] = narrow<T>(f.force);
        }
        if (const Status status = put(sim_.force, first, values); status != Status::ok) {
          return status;
        }
        cloth->forces_changed = false;
      }
      first += elements;
    }
    return Status::ok;
  }

  /// Parameters of the cloths; those that have moved since the last upload no longer start.
  Status upload_params(const ArenaInput& in) {
    position_form_ = in.world->form == Form::position;
    fill_params(in, params_);
    sim_.windy = std::any_of(params_.begin(), params_.end(), [](auto& p) { return p.in_wind; });
    return backend_.to_device(at<ClothParams<T>>(layout_.cloths), params_.data(),
                              params_.size() * sizeof(ClothParams<T>));
  }

  /// Reads elements [first, first + count) of an array of vectors.
  Status fetch(const Vec3Array<T>& from, int first, size_t count, std::vector<Vec3<T>>& out) {
    out.resize(count);
    if (count == 0) return Status::ok;
    const size_t step = static_cast<size_t>(this->step());
    std::vector<T> line((count - 1) * step + 1);
    for (size_t c = 0; c < 3; ++c) {
      const Status status = backend_.to_host(
          line.data(), from.data + size_t(first) * step + c * from.pitch, line.size() * sizeof(T));
      if (status != Status::ok) return status;
      T Vec3<T>::*const member = c == 0 ? &Vec3<T>::x : c == 1 ? &Vec3<T>::y : &Vec3<T>::z;
      for (size_t i = 0; i < count; ++i) out[i].*member = line[i * step];
    }
    return Status::ok;
  }

  /// Writes elements from `first` on of an array of vectors.
  Status put(const Vec3Array<T>& to, int first, const std::vector<Vec3<T>>& values) {
    const size_t step = static_cast<size_t>(this->step());
    std::vector<T> line(values.size() * step);
    T* at = to.data + size_t(first) * step;
    for (size_t c = 0; c < 3; ++c) {
      T Vec3<T>::*const member = c == 0 ? &Vec3<T>::x : c == 1 ? &Vec3<T>::y : &Vec3<T>::z;
      for (size_t i = 0; i < values.size(); ++i)
        line[i * step + c * to.pitch % step] = values[i].*member;
      if (step > 1 && c < 2) continue;  // x, y and z lie together
      const Status status = backend_.to_device(step > 1 ? at : at + c * to.pitch, line.data(),
                                               line.size() * sizeof(T));
      if (status != Status::ok) return status;
    }
    return Status::ok;
  }

  ContextState& context_;
  const Backend& backend_;
  plan::Plan plan_;
  plan::Layout layout_;
  char* memory_ = nullptr;
  Simulation<T> sim_{};
  Vec3Array<T> before_{nullptr, 0};  ///< null: this world does not interpolate
  bool position_form_ = false;

  std::vector<ClothParams<T>> params_;
  std::vector<Survey<T>> found_;
  ColliderInputs<T> colliders_;
  PinInputs<T> pins_;
};

}  // namespace

std::unique_ptr<Arena> make_arena(Precision precision, ContextState& context) {
  if (precision == Precision::float64) return std::make_unique<ArenaOf<double>>(context);
  return std::make_unique<ArenaOf<float>>(context);
}

}  // namespace weft::api
