#include "printing/Calibration.h"

#include <algorithm>

namespace dipwright {

const QList<QPageSize>& calibrationPapers() {
    static const QList<QPageSize> papers{QPageSize(QPageSize::A4), QPageSize(QPageSize::A5),
                                         QPageSize(QPageSize::A3), QPageSize(QPageSize::A2),
                                         QPageSize(QPageSize::Letter)};
    return papers;
}

CalibrationPage calibrationPage(const PrinterProfile& profile, QSizeF paper, bool verifies) {
    CalibrationPage page;
    page.paper = paper;
    page.printer = profile.name;
    for (const Millimetres margin : profile.margins) {
        page.clearance = std::max(page.clearance, margin + Millimetres(1));
    }
    if (verifies) {
        page.scaleX = profile.scaleX;
        page.scaleY = profile.scaleY;
    }
    return page;
}

PrinterProfile calibrated(PrinterProfile profile, const CalibrationPage& page, Millimetres x,
                          Millimetres y) {
    const CalibrationLengths nominal = calibrationLengths(page);
    profile.scaleX = calibratedScale(page.scaleX, nominal.x, x);
    profile.scaleY = calibratedScale(page.scaleY, nominal.y, y);
    return profile;
}

} // namespace dipwright
