#include "printing/Calibration.h"

#include "base/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {
namespace {

// Returns the larger error of the two measured rulers, as a share. It is infinite if the paper is
// too small for the page.
double rulerError(const CalibrationPage& page, Millimetres x, Millimetres y) {
    try {
        const CalibrationLengths nominal = calibrationLengths(page);
        return std::max(std::abs(x / nominal.x - 1), std::abs(y / nominal.y - 1));
    } catch (const Error&) {
        return std::numeric_limits<double>::infinity();
    }
}

} // namespace

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

std::optional<QPageSize> otherPaperOf(const PrinterProfile& profile, const CalibrationPage& page,
                                      Millimetres x, Millimetres y) {
    constexpr double mostOfPrinter = 0.02;
    const double own = rulerError(page, x, y);
    double least = own;
    std::optional<QPageSize> other;
    for (const QPageSize& paper : calibrationPapers()) {
        const QSizeF size = paper.size(QPageSize::Millimeter);
        const double error = rulerError(calibrationPage(profile, size, page.verifies()), x, y);
        if (error < least && size != page.paper) {
            least = error;
            other = paper;
        }
    }
    return own > mostOfPrinter ? other : std::nullopt;
}

PrinterProfile calibrated(PrinterProfile profile, const CalibrationPage& page, Millimetres x,
                          Millimetres y) {
    const CalibrationLengths nominal = calibrationLengths(page);
    profile.scaleX = calibratedScale(page.scaleX, nominal.x, x);
    profile.scaleY = calibratedScale(page.scaleY, nominal.y, y);
    return profile;
}

} // namespace dipwright
