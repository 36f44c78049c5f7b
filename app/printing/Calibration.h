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

// If the measured rulers `x` and `y` do not fit those of `page` but are nearer to those of the same
// page on another paper, returns that paper, because the page was then printed on it. A ruler fits
// if its error is at most 2 %.
std::optional<QPageSize> otherPaperOf(const PrinterProfile& profile, const CalibrationPage& page,
                                      Millimetres x, Millimetres y);

// Returns the profile with the scale that follows from the measured rulers `x` and `y` of `page`.
// Throws Error as calibratedScale() does.
PrinterProfile calibrated(PrinterProfile profile, const CalibrationPage& page, Millimetres x,
                          Millimetres y);

} // namespace dipwright
