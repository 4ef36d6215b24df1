/// Studios with a solve: of a made-up arm whose every angle is known, or of a simulated take.
#pragma once

#include <QEventLoop>
#include <QScreen>
#include <QThread>
#include <QTimer>
#include <atomic>
#include <cmath>
#include <mutex>

#include "body/rig.h"
#include "common/theme.h"
#include "solve/compose.h"
#include "ui/support/studio_fixture.h"
#include "workspaces/solve/solve_model.h"

namespace limbwave::ui::testing {

/// A take of the line-in arm without any samples: what widgets need of it.
inline take::Take made_up_take(const QString& folder, double seconds) {
  take::Take take;
  take.folder = folder.toStdString();
  take.info.format.rate = SampleRate{48000.0};
  take.info.frames = static_cast<std::int64_t>(48000 * (seconds + 2.0));
  take.info.rig = body::load_rig("line-in-arm").value();
  take.info.skeleton = body::load_skeleton(take.info.rig.skeleton).value();
  take.info.segments = {{"range", SampleIndex{0}, SampleCount{96000}},
                        {"capture", SampleIndex{96000}, SampleCount{static_cast<std::int64_t>(48000 * seconds)}}};
  take.events = {{SampleIndex{96000 + 48000}, "marker", "clap", 0},
                 {SampleIndex{96000 + 144000}, "dropped", "120 samples were lost", 120},
                 {SampleIndex{96000 + 192000}, "gain-changed", "The volume was moved", 0}};
  return take;
}

/// World orientations of the made-up arm at a time: it swings up and down in the plane y = 0.
inline std::vector<std::vector<Eigen::Quaterniond>> made_up_motion(const body::Skeleton& skeleton,
                                                                   const std::vector<double>& times) {
  std::vector<std::vector<Eigen::Quaterniond>> lists(skeleton.segments.size());
  for (std::size_t s = 0; s < lists.size(); ++s) {
    for (const double t : times) {
      const double elevation = s == 0 ? M_PI / 2 : 0.7 * std::sin(1.3 * t + 0.5 * static_cast<double>(s)) - 0.2;
      lists[s].emplace_back(Eigen::AngleAxisd(-elevation, Eigen::Vector3d::UnitY()));
    }
  }
  return lists;
}

/// Frames at 60 Hz.
inline solve::Solve made_up_solve(const take::Take& take, const solve::SolveSettings& settings, double seconds) {
  solve::Solve made;
  made.settings = settings;
  std::vector<double> times(static_cast<std::size_t>(60 * seconds) + 1);
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = static_cast<double>(i) / 60.0;
  }
  made.clip = solve::compose_clip(take.info.skeleton, times, made_up_motion(take.info.skeleton, times),
                                  settings.headings, 60.0);
  for (const body::Accelerometer& sensor : take.info.rig.accelerometers) {
    std::vector<float>& trust = made.trust.emplace_back();
    for (const double t : times) {
      trust.push_back(static_cast<float>(0.5 + 0.5 * std::sin(3.0 * t + static_cast<double>(made.trust.size()))));
    }
    made.report.sensors.push_back({sensor.name, 1.0, 0.82, 1.003});
  }
  made.report.calibration = "calibration poses in the take";
  made.report.line.decided = made.report.line.locked = true;
  made.report.line.cycles = static_cast<std::int64_t>(times.size());
  made.report.line.cycle_rate_hz = 60.0;
  made.report.take_seconds = seconds;
  return made;
}

/// Services that remember what was asked of them, without a disk. The counters are read while jobs run.
struct FakeSolving {
  double seconds = 8.0;
  std::atomic<int> solved{0}, saved{0}, loaded{0};
  std::atomic<bool> block{false};  ///< Solving goes on until it is cancelled.
  std::mutex mutex;
  std::optional<Error> failure;
  std::optional<solve::Solve> stored;

  SolveServices services() {
    SolveServices table;
    table.solve = [this](const take::Take& take, const solve::SolveSettings& settings,
                         const Progress& progress) -> Result<solve::Solve> {
      ++solved;
      for (int i = 0; block.load(); ++i) {
        if (!progress.report(std::min(0.43, 0.01 * i), "decoding")) {
          return cancelled();
        }
        QThread::msleep(5);
      }
      if (failure) {
        return *failure;
      }
      return made_up_solve(take, settings, seconds);
    };
    table.save = [this](const take::Take&, const solve::Solve& solve) {
      const std::lock_guard lock(mutex);
      stored = solve;
      ++saved;
      return Status();
    };
    table.load = [this](const take::Take&, const std::string&) -> Result<solve::Solve> {
      const std::lock_guard lock(mutex);
      ++loaded;
      return *stored;
    };
    table.load_settings = [this](const take::Take&, const std::string&) -> Result<solve::SolveSettings> {
      const std::lock_guard lock(mutex);
      return stored->settings;
    };
    table.set_aside = [](const take::Take& take, const std::string& name) -> Result<std::filesystem::path> {
      return take.folder / "solves" / (name + ".damaged-1");
    };
    table.list = [this](const take::Take&) {
      const std::lock_guard lock(mutex);
      return stored ? std::vector<std::string>{stored->settings.name} : std::vector<std::string>();
    };
    table.export_file = interchange::export_file;
    return table;
  }
};

/// A studio whose solving is replaced.
struct SolveStudio {
  explicit SolveStudio(SolveServices solving, StudioServices services = {})
      : context(std::make_unique<StudioContext>(std::move(services), folder.filePath(QStringLiteral("settings")))),
        model(new SolveModel(*context, std::move(solving))) {
    QDir().mkpath(folder.filePath(QStringLiteral("takes")));
    context->set_takes_folder(folder.filePath(QStringLiteral("takes")));
    window = std::make_unique<MainWindow>(*context, studio_parts());
    window->resize(1440, 900);
    window->move(0, 0);
    window->show();
  }
  SolveStudio(const SolveStudio&) = delete;
  SolveStudio& operator=(const SolveStudio&) = delete;
  ~SolveStudio() {
    window.reset();
    context.reset();
  }

  [[nodiscard]] QString take_folder(const QString& name) const {
    return folder.filePath(QStringLiteral("takes/") + name);
  }

  /// The window as it is on screen, with what the graphics card drew.
  [[nodiscard]] QImage screen() const {
    // The X server copies the frame on its own time.
    QEventLoop loop;
    QTimer::singleShot(250, &loop, &QEventLoop::quit);
    loop.exec();
    return window->screen()->grabWindow(window->winId()).toImage();
  }

  QTemporaryDir folder;
  std::unique_ptr<StudioContext> context;
  SolveModel* model;  ///< Owned by the context.
  std::unique_ptr<MainWindow> window;
};

}  // namespace limbwave::ui::testing
