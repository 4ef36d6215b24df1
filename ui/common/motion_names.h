/// The simulator's motions by names for people.
#pragma once

#include <QString>

namespace limbwave::ui {

/// "Waving" for "wave"; the motion's own name when it is unknown.
QString motion_title(const QString& motion);
/// What is special about it, a few words.
QString motion_hint(const QString& motion);

}  // namespace limbwave::ui
