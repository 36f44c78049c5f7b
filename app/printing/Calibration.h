// Makes a printer's calibration page and computes its scale from the measured rulers.
#pragma once

#include "settings/Profile.h"
#include "sheet/page/CalibrationPage.h"

#include <QPageSize>

namespace dipwright {

// Returns the papers that can be chosen for calibration pages, A4 first.
const QList<QPageSize>& calibrationPapers();

// Returns the calibration page. Its rulers stay inside the profile's margins. The first page is
// printed without correction. The second page (`verifies`) uses the profile's correction.
CalibrationPage calibrationPage(const PrinterProfile& profile, QSizeF paper, bool verifies);

// Returns the profile with the scale that follows from the measured rulers `x` and `y` of `page`.
// Throws Error as calibratedScale() does.
PrinterProfile calibrated(PrinterProfile profile, const CalibrationPage& page, Millimetres x,
                          Millimetres y);

} // namespace dipwright
