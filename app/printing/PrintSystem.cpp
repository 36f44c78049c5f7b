#include "printing/PrintSystem.h"

#include "base/Error.h"

#include <QCoreApplication>

namespace dipwright {

#ifndef DIPWRIGHT_HAS_CUPS
std::unique_ptr<PrintSystem> cupsPrintSystem() {
    return nullptr;
}
#endif

#ifndef DIPWRIGHT_HAS_QT_PRINTING
std::unique_ptr<PrintSystem> qtPrintSystem() {
    return nullptr;
}
#endif

std::unique_ptr<PrintSystem> printSystem() {
    if (auto cups = cupsPrintSystem()) {
        return cups;
    }
    if (auto qt = qtPrintSystem()) {
        return qt;
    }
    throw Error(
        QCoreApplication::translate(
            "dipwright::Printing",
            "This program was built without printing; print the sheet's PDF at 100 % instead"),
        QStringLiteral("print"));
}

} // namespace dipwright
