// Prints through QPrinter, which exists on every platform of Qt.
#include "printing/PrintSystem.h"

#include "base/Error.h"
#include "base/Units.h"

#include <QCoreApplication>
#include <QPageLayout>
#include <QPrinter>
#include <QPrinterInfo>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Printing)
};

// Throws if there is no printer of this name. QPrinter would silently print to the default printer.
QPrinterInfo named(const QString& name) {
    return name.isEmpty() ? QPrinterInfo() : QPrinterInfo::printerInfo(name);
}

PrinterState stateOf(QPrinter::PrinterState state) {
    switch (state) {
    case QPrinter::Active:
        return PrinterState::Printing;
    case QPrinter::Error:
    case QPrinter::Aborted:
        return PrinterState::Stopped;
    case QPrinter::Idle:
        break;
    }
    return PrinterState::Idle;
}

QMarginsF reachOf(QPrinter& printer, const QPageSize& size) {
    printer.setPageSize(size);
    printer.setFullPage(false);
    const QMarginsF margins = printer.pageLayout().minimumMargins();
    const QPageLayout layout(size, QPageLayout::Portrait, margins, printer.pageLayout().units());
    return layout.margins(QPageLayout::Millimeter);
}

class QtPrintSystem : public PrintSystem {
public:
    QStringList printers() override {
        QStringList names = QPrinterInfo::availablePrinterNames();
        names.sort();
        return names;
    }

    std::optional<PrinterInfo> printer(const QString& name) override {
        const QPrinterInfo found = named(name);
        if (found.isNull()) {
            return std::nullopt;
        }
        PrinterInfo info;
        info.name = name;
        info.description = found.description();
        info.isDefault = found.isDefault();
        info.state = stateOf(found.state());
        info.printsColour = found.supportedColorModes().contains(QPrinter::Color);
        QPrinter printer(found, QPrinter::HighResolution);
        for (const QPageSize& size : found.supportedPageSizes()) {
            info.media.push_back(
                {size.key(), size.size(QPageSize::Millimeter), reachOf(printer, size)});
        }
        return info;
    }

    PrintJob submit(const PrintTask& task) override {
        QPrinter printer(named(task.printer), QPrinter::HighResolution);
        printer.setDocName(task.title);
        printer.setColorMode(QPrinter::Color);
        printer.setDuplex(QPrinter::DuplexNone);
        printer.setCopyCount(1);   // the task already contains each copy as a page
        printer.setFullPage(true); // the origin is the corner of the paper, not of its margins
        printer.setPageLayout(QPageLayout(QPageSize(task.media.size, QPageSize::Millimeter),
                                          QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)));
        QPainter painter;
        if (!painter.begin(&printer)) {
            throw Error(Text::tr("The printer refuses the job"), task.printer);
        }
        for (int page = 0; page < task.pages; ++page) {
            if (page > 0) {
                printer.newPage();
            }
            painter.resetTransform();
            painter.scale(printer.logicalDpiX() / millimetresPerInch,
                          printer.logicalDpiY() / millimetresPerInch);
            task.paint(painter, page);
        }
        if (!painter.end()) {
            throw Error(Text::tr("The sheet could not be sent to the printer"), task.printer);
        }
        return {task.printer, 0};
    }

    JobStatus status(const PrintJob&) override { return {JobState::HandedOver, {}}; }
    void cancel(const PrintJob&) override {}
};

} // namespace

std::unique_ptr<PrintSystem> qtPrintSystem() {
    return std::make_unique<QtPrintSystem>();
}

} // namespace dipwright
