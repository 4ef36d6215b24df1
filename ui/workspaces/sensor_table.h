/// Which sensor is worn where, socket by socket: its place and its serial. A place that is given to one sensor goes to
/// the other one in exchange, so that no place is ever named twice.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

class QComboBox;
class QLineEdit;

namespace limbwave::ui {

class SensorTable : public QWidget {
  Q_OBJECT
 public:
  /// One row per socket; `hints`: what a sensor is known by without a serial.
  SensorTable(const std::vector<std::string>& places, const std::vector<std::string>& serials,
              const std::vector<std::string>& hints, QWidget* parent);
  [[nodiscard]] std::vector<std::string> places() const { return places_; }
  [[nodiscard]] std::vector<std::string> serials() const;
  /// What is wrong, in words; empty: nothing.
  [[nodiscard]] QString problem() const;

 Q_SIGNALS:
  void changed();

 private:
  void choose(std::size_t row, const QString& place);
  std::vector<std::string> places_;
  std::vector<QComboBox*> boxes_;
  std::vector<QLineEdit*> serials_;
};

}  // namespace limbwave::ui
