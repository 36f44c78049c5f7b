// From a printer's profile to its calibration page, and from what was measured there back.
#pragma once

#include "settings/Profile.h"
#include "sheet/page/CalibrationPage.h"

#include <QPageSize>

namespace dipwright {

// The papers to choose from, A4 first.
const QList<QPageSize>& calibrationPapers();

// Clear of the profile's margins. The first page shows the printer as it is; the second, which
// `verifies`, what the profile makes of it.
CalibrationPage calibrationPage(const PrinterProfile& profile, QSizeF paper, bool verifies);

// The profile after the rulers of `page` have measured `x` and `y`. Throws Error as
// calibratedScale() does.
PrinterProfile calibrated(PrinterProfile profile, const CalibrationPage& page, Millimetres x,
                          Millimetres y);

} // namespace dipwright
