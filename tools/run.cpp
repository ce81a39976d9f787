// weft run: everything is checked, then the outputs are opened, then time passes.
#include "commands.h"

#include "arguments.h"
#include "collect_report.h"
#include "frame_output.h"
#include "lengthening.h"
#include "output.h"
#include "output_paths.h"
#include "progress.h"
#include "remarks.h"
#include "step_bound.h"
#include "stop_signal.h"
#include "windless.h"

#include "io/csv_writer.h"
#include "io/error.h"
#include "io/output_file.h"
#include "io/scene_size.h"
#include "io/text_cursor.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace weft::tools {
namespace {

/// The options as values, before anything is read.
struct RunRequest {
  explicit RunRequest(const RunOptions& options) : context(context_desc(options)) {
    if (!options.time.empty()) duration = seconds_argument("--time", options.time, false);
    if (!options.every.empty()) frames.every = seconds_argument("--every", options.every, true);
    if (!options.size.empty()) size = size_argument("--size", options.size);
    frames.folder = options.out;
    frames.formats = frame_formats(options.format.empty() ? "obj" : options.format);
    frames.normals = options.normals;
    const bool about_frames = !options.every.empty() || !options.format.empty() ||
                              !options.size.empty() || options.normals;
    if (options.out.empty() && about_frames) {
      throw io::InputError(
          "--out: is missing (--every, --format, --size and --normals are about its files) give a "
          "folder");
    }
    refuse_vain(options);
  }

  ContextDesc context;
  std::optional<double> duration;
  std::optional<PictureSize> size;
  FrameSettings frames;

 private:
  void refuse_vain(const RunOptions& options) const {
    if (size && !frames.has(FrameFormat::png) && !frames.has(FrameFormat::mp4)) {
      throw io::InputError("--size: " + io::quoted(options.size) +
                           " is about pictures (--format has neither png nor mp4) add one of them");
    }
    if (frames.normals && !frames.has(FrameFormat::obj) && !frames.has(FrameFormat::ply)) {
      throw io::InputError(
          "--normals: is about meshes (--format has neither obj nor ply) add one of them");
    }
  }
};

io::Scene read_scene(const RunOptions& options, const RunRequest& request) {
  io::Scene scene = io::read_scene(options.scene);
  if (request.duration) {
    scene.time.duration = *request.duration;
    io::frame_count(scene.time, "--time");
  }
  if (request.size) {
    scene.camera.width = request.size->width;
    scene.camera.height = request.size->height;
  }
  return scene;
}

void check_paths(const RunOptions& options, const RunRequest& request, const io::Scene& scene) {
  OutputPaths paths(scene);
  paths.add("--final", options.final_file);
  paths.add("--report", options.report);
  if (!options.out.empty()) paths.add_frames(request.frames, scene);
}

void require_memory(const io::Scene& scene, uint64_t bytes) {
  if (const auto problem = io::beyond_memory(bytes)) {
    throw io::InputError(scene.file + ": " + *problem);
  }
}

io::RunningScene build_runnable(const io::Scene& scene, const RunRequest& request) {
  require_memory(scene, io::bytes_to_run(scene));
  io::RunningScene made = io::build(scene, request.context);
  const auto plan = made.world.plan();
  made.require(plan.status(), scene.file);
  require_memory(scene, io::bytes_to_run(scene, plan->bytes_total));
  if (!scene.solver.unsafe) {
    if (const auto problem = beyond_bound(scene, made, made.world.stability())) {
      throw io::InputError(scene.file + ": $.time.substeps: " + *problem);
    }
  }
  made.require(made.world.substeps(scene.time.frame).status(), scene.file + ": $.time");
  return made;
}

void write_final(const std::string& path, const io::Scene& scene, io::RunningScene& made) {
  io::FinalWriter writer(path);
  std::vector<double3> positions, velocities;
  for (size_t i = 0; i < made.cloths.size(); ++i) {
    positions.resize(io::vertex_count(made, i));
    velocities.resize(positions.size());
    made.require(made.world.read_positions(made.cloths[i], positions.data()), scene.file);
    made.require(made.world.read_velocities(made.cloths[i], velocities.data()), scene.file);
    io::spread(made, i, positions.data());
    io::spread(made, i, velocities.data());
    writer.add_cloth(i, positions, velocities);
  }
  writer.commit();
}

/// Lengthening that no cloth survives. It is measured only where some spring is long enough.
struct Absurdity {
  static constexpr double absurd = 10;

  Lengthening lengthening;
  double most = 0;

  void look(io::RunningScene& made, double stretch) {
    if (stretch > absurd) most = std::max(most, lengthening.most(made));
  }
};

/// Writes the frame if it is due; then it counts for the largest stretch, too.
void update_frames(FrameOutput* frames, uint64_t frame, io::RunningScene& made, io::Report& report,
                   Absurdity& absurd) {
  if (!frames || !frames->update(frame, made)) return;
  const double stretch = made.world.mechanics()->stretch;
  report.largest_stretch = std::max(report.largest_stretch, stretch);
  absurd.look(made, stretch);
}

void prepare(const io::Scene& scene, io::RunningScene& made) {
  const LongWork building("the preparation");
  made.require(made.world.prepare(scene.time.frame), scene.file);
}

/// Why a run ended before its time; empty when it did not.
std::string simulate(const io::Scene& scene, io::RunningScene& made, FrameOutput* frames,
                     io::Report& report, Absurdity& absurd) {
  const uint64_t count = io::frame_count(scene.time, "$.time.duration");
  const std::function<void()> rescue = [frames] {
    if (frames) frames->commit();
  };
  prepare(scene, made);
  update_frames(frames, 0, made, report, absurd);
  Progress progress(count);
  for (uint64_t frame = 1; frame <= count; ++frame) {
    if (stop_signal() != 0) {
      begin_to_stop();
      return "stopped after frame " + std::to_string(frame - 1) + " of " + std::to_string(count) +
             " (signal " + std::to_string(stop_signal()) + ") run it again for the rest";
    }
    const std::string which = std::to_string(frame) + " of " + std::to_string(count);
    Status status = Status::ok;
    {
      const LongWork step("frame " + which, rescue);
      status = made.world.step(scene.time.frame);
    }
    collect_events(made, report.events);
    if (status == Status::diverged) {
      return "stopped in frame " + which + ": " + made.log->last_error(status);
    }
    made.require(status, scene.file);
    update_frames(frames, frame, made, report, absurd);
    progress.update(frame);
  }
  return "";
}

void print_summary(const io::Scene& scene, const io::Report& report) {
  std::vector<std::pair<std::string, std::string>> lines{
      {"scene", scene.file},
      {"particles", std::to_string(report.particles)},
      {"springs", std::to_string(report.springs)},
      {"frames", std::to_string(report.frames) + " of " + seconds_text(scene.time.frame)},
      {"substeps", std::to_string(report.substeps_per_frame) + " per frame, dt " +
                       seconds_text(report.dt) + ", bound " + seconds_text(report.dt_bound)},
      {"ran on", report.backend + " " + report.isa + ", " + std::to_string(report.threads) +
                     " threads, " + report.precision},
      {"time", seconds_text(report.wall_seconds) + " (" + seconds_text(report.cpu_seconds) +
                   " of processors)"}};
  if (const auto cost = report.ns_per_particle_step()) {
    lines.back().second += ", " + seconds_text(report.wall_seconds / double(report.frames)) +
                           " per frame, " + figure(*cost) + " ns per particle and step";
  }
  lines.push_back({"stretch", figure(100 * report.largest_stretch) + " % at most"});
  if (scene.self_collision) {
    lines.push_back({"contacts", std::to_string(report.contacts) + " pairs touch at the end, " +
                                     std::to_string(report.pairs_excluded) +
                                     " are too near at rest to do so"});
  }
  lines.push_back({"memory", bytes_text(double(report.bytes_total))});
  lines.push_back({"state", io::hash_text(report.state_hash)});
  for (const io::ReportEvent& event : report.events) {
    lines.push_back({"event", event.type + " at " + seconds_text(event.time) + ": " + event.text});
  }
  print_lines(lines);
}

}  // namespace

int run_command(const RunOptions& options) {
  const RunRequest request(options);
  catch_stop_signals();
  const io::Scene scene = read_scene(options, request);
  check_paths(options, request, scene);
  io::RunningScene made = build_runnable(scene, request);
  std::optional<FrameOutput> frames;
  if (!options.out.empty()) frames.emplace(request.frames, scene, made);
  for (const std::string& path : {options.final_file, options.report}) {
    if (!path.empty()) io::probe_output(path);
  }
  for (const Windless& cloth : windless_cloths(scene, made)) {
    print_message("warning: " + scene.file + ": " + cloth.text);
  }
  for (const Remark& remark : remarks(scene, made)) {
    if (remark.severity == Severity::info) continue;
    print_message("warning: " + scene.file + ": " + subject(scene, remark) + remark.text);
  }
  Absurdity absurd{Lengthening(scene, made)};
  io::Report report;
  collect_fallback(made, report.events);
  std::string early = simulate(scene, made, frames ? &*frames : nullptr, report, absurd);
  if (frames) frames->commit();
  collect_figures(scene, made, report);
  if (early.empty() && !std::isfinite(report.mechanics.kinetic)) {
    early =
        "ends with velocities that are not finite (forces or masses are extreme) give less of "
        "them, or \"float64\"";
  }
  if (!options.report.empty()) io::write_report(options.report, report);
  if (!early.empty()) throw io::OutputError(scene.file + ": " + early);
  absurd.look(made, report.mechanics.stretch);
  if (absurd.most > Absurdity::absurd) {
    print_message("warning: " + scene.file + ": a spring is " + figure(1 + absurd.most) +
                  " times as long as at rest (the cloth is soft, or has gained energy) give more "
                  "stiffness or damping, or a smaller $.solver.safety");
  }
  if (!options.final_file.empty()) write_final(options.final_file, scene, made);
  if (options.json)
    print_json(to_json(report));
  else
    print_summary(scene, report);
  return done;
}

}  // namespace weft::tools
