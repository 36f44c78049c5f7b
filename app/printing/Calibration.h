// Makes a printer's calibration page and computes its scale from the measured rulers.
#pragma once

#include "settings/Profile.h"
#include "sheet/page/CalibrationPage.h"

#include <QPageSize>
#include <optional>

namespace dipwright {

// Returns the papers that can be chosen for calibration pages, A4 first.
const QList<QPageSize>& calibrationPapers();

// Returns the calibration page. Its rulers stay inside the profile's margins. The first page is
// printed without correction. The second page (`verifies`) uses the profile's correction.
CalibrationPage calibrationPage(const PrinterProfile& profile, QSizeF paper, bool verifies);

// Finds out whether the page was printed on another paper than that of `page`. `x` and `y` are the
// lengths measured on its rulers. If one of them is off by more than 2 %, returns the paper whose
// rulers are nearest to both lengths; nothing if that is the paper of `page`.
std::optional<QPageSize> otherPaperOf(const PrinterProfile& profile, const CalibrationPage& page,
                                      Millimetres x, Millimetres y);

// Returns the profile with the scale that follows from the measured rulers `x` and `y` of `page`.
// Throws Error as calibratedScale() does.
PrinterProfile calibrated(PrinterProfile profile, const CalibrationPage& page, Millimetres x,
                          Millimetres y);

} // namespace dipwright
