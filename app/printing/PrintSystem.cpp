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
    throw Error(QCoreApplication::translate("dipwright::Printing",
                                            "This version of the program cannot print; print the "
                                            "sheet's PDF at 100 % with another program"),
                QStringLiteral("print"));
}

} // namespace dipwright
