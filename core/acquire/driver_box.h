/// A driver box on a serial line: samples without a shift, whatever the line does to them.
#pragma once

#include <memory>
#include <string>

#include "acquire/box_source.h"

namespace limbwave::acquire {

struct DriverBoxSettings {
  double patience_s = 10.0;  ///< How long opening waits for a hello.
  double stall_s = 0.5;      ///< Silence that counts as a stall.
  double backlog_s = 8.0;    ///< What is kept for a consumer that is late; what comes beyond is lost, and told.
};

/// A running box. A thread of its own reads the line, opens it again when it was lost, and continues.
class DriverBox : public BoxSource {
 public:
  /// Opens the port, asks who is there. Fails when the port cannot be opened or nobody answers.
  static Result<std::unique_ptr<DriverBox>> open(const std::string& port, const DriverBoxSettings& settings = {});
  ~DriverBox() override;
  DriverBox(const DriverBox&) = delete;
  DriverBox& operator=(const DriverBox&) = delete;

  [[nodiscard]] BoxHello hello() const override;
  [[nodiscard]] StreamFormat format() const override;
  [[nodiscard]] std::string title() const override;
  Status set_schedule(const std::vector<std::uint8_t>& schedule) override;
  Status start() override;
  void stop() override;
  BoxPart pull(double timeout_s) override;
  [[nodiscard]] BoxCounters counters() const override;
  [[nodiscard]] BoxStatus status() const override;
  [[nodiscard]] bool connected() const override;

 private:
  struct Impl;
  explicit DriverBox(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::acquire
