// The weft program: command line to commands, exceptions to exit codes.
#include "commands.h"

#include "output.h"

#include "io/error.h"
#include "io/message_log.h"
#include "io/nearest.h"
#include "io/text_cursor.h"

#include "weft/weft.hpp"

#include <CLI/CLI.hpp>

#include <fcntl.h>

#include <csignal>
#include <functional>

namespace weft::tools {
namespace {

int fail(int code, const std::string& text) {
  print_message(text);
  return code;
}

int exit_code(Status status) {
  switch (status) {
    case Status::no_device:
    case Status::version_mismatch:
      return not_available;
    case Status::out_of_memory:
    case Status::device_lost:
    case Status::diverged:
      return stopped;
    default:
      return bad_input;
  }
}

int guarded(const std::function<int()>& command) {
  try {
    return command();
  } catch (const io::InputError& error) {
    return fail(bad_input, error.what());
  } catch (const io::OutputError& error) {
    return fail(stopped, error.what());
  } catch (const io::UnavailableError& error) {
    return fail(not_available, error.what());
  } catch (const io::CoreError& error) {
    return fail(exit_code(error.status), error.what());
  } catch (const std::bad_alloc&) {
    return fail(stopped, "out of memory (the scene is too large for this machine) make it smaller");
  } catch (const std::exception& error) {
    return fail(stopped, error.what());
  }
}

void add_common(CLI::App* command, CommonOptions& options) {
  command->add_option("SCENE", options.scene, "Scene file (JSON)")->required();
  command->add_option("--backend", options.backend, "auto, omp, cuda or hip");
  command->add_option("--threads", options.threads, "Threads, also above the number of cores");
  command->add_option("--isa", options.isa, "x86-64 level of the host kernels: auto, v2, v3 or v4");
  command->add_flag("--json", options.json, "One JSON document on standard output");
}

/// Holds what the commands point to.
class Program {
 public:
  Program() {
    app_.set_version_flag("--version", std::string("weft ") + build_info());
    app_.require_subcommand(1);
    add_run();
    add_scene_commands();
    add_bench();
    add_later("accuracy", "Not available yet: error against time over methods and steps");
  }

  int run(int argc, char** argv) {
    if (argc > 1) refuse_unknown_command(argv[1]);
    try {
      app_.parse(argc, argv);
    } catch (const CLI::Success& asked) {
      return app_.exit(asked);
    } catch (const CLI::ParseError& error) {
      return fail(bad_input,
                  std::string(error.what()) + " (run 'weft --help') correct the command");
    }
    return guarded(command_);
  }

 private:
  CLI::App* add(const char* name, const char* summary, std::function<int()> command) {
    CLI::App* made = app_.add_subcommand(name, summary);
    made->callback([this, command] { command_ = command; });
    return made;
  }

  // The parser would only say that a command is missing.
  void refuse_unknown_command(const std::string& word) const {
    std::vector<const char*> names;
    std::string all;
    for (const CLI::App* command : app_.get_subcommands({})) {
      if (word == command->get_name()) return;
      names.push_back(command->get_name().c_str());
      all += (all.empty() ? "" : ", ") + command->get_name();
    }
    if (word.empty() || word[0] == '-') return;
    const std::string nearest = io::nearest_word(word, names);
    throw io::InputError(io::quoted(word) + " is not a command (known are " + all + ") " +
                         (nearest.empty() ? "give one" : "did you mean '" + nearest + "'?"));
  }

  void add_run() {
    CLI::App* run = add("run", "Simulate a scene", [this] { return run_command(run_); });
    add_common(run, run_);
    run->add_option("--time", run_.time, "Seconds to simulate instead of the scene's duration");
    run->add_option("--out", run_.out, "Folder for frames");
    run->add_option("--every", run_.every, "Seconds between frames; default every frame");
    run->add_option("--format", run_.format,
                    "Formats of the frames: obj,ply,pc2,png,mp4; default obj");
    run->add_option("--size", run_.size, "Size of pictures: WIDTHxHEIGHT; default the scene's");
    run->add_flag("--normals", run_.normals, "Normals of the vertices in the frames");
    run->add_option("--final", run_.final_file, "CSV file for the final positions and velocities");
    run->add_option("--report", run_.report, "JSON file for the figures of the run");
    // An empty value is a variable that was not set, not an option that was not given.
    for (CLI::Option* option : run->get_options()) {
      if (option->get_items_expected_max() == 0) continue;
      option->check([](const std::string& value) {
        return value.empty() ? std::string("the value is empty") : std::string();
      });
    }
  }

  void add_scene_commands() {
    add_common(add("check", "Validate a scene; print counts, stable step, memory, diagnostics",
                   [this] { return check_command(common_); }),
               common_);
    add_common(add("plan", "Print the passes that a scene needs",
                   [this] { return plan_command(common_); }),
               common_);
    add_common(add("recall", "Self-collision: pairs found at the start against all that are near",
                   [this] { return recall_command(common_); }),
               common_);
  }

  void add_bench() {
    CLI::App* bench = add("bench", "Run benchmarks", [this] { return bench_command(bench_); });
    bench->add_option("NAME", bench_.names, "Tables to run; default all");
    bench->add_flag("--list", bench_.list, "Name the tables");
    bench->add_flag("--quick", bench_.quick, "Fewer and shorter runs");
    bench->add_flag("--json", bench_.json, "One JSON document on standard output");
  }

  void add_later(const std::string& name, const char* summary) {
    add(name.c_str(), summary, [name]() -> int {
      throw io::InputError(name +
                           ": is not available in this version (nothing computes it yet) "
                           "use run, check, plan, recall or bench");
    })->allow_extras();
  }

  CLI::App app_{"Cloth and other deformable surfaces from scene files", "weft"};
  std::function<int()> command_;
  RunOptions run_;
  CommonOptions common_;
  BenchOptions bench_;
};

}  // namespace
}  // namespace weft::tools

int main(int argc, char** argv) {
  // Beyond a file size limit write() shall fail like on a full disk, not kill the program.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  // A standard stream that is closed would be the next file that is opened.
  for (int descriptor = 0; descriptor <= 2; ++descriptor) {
    if (::fcntl(descriptor, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
  }
  return weft::tools::guarded([&] { return weft::tools::Program().run(argc, argv); });
}
