#include "cli/PrintOptions.h"

#include "cli/Arguments.h"

#include "disk/PlainFile.h"
#include "project/Project.h"

#include <algorithm>

namespace dipwright::cli {
namespace {

const QString printerOption = QStringLiteral("printer");
const QString printersOption = QStringLiteral("printers");
const QString toOption = QStringLiteral("to");
const QString profileOption = QStringLiteral("profile");
const QString otherPaperOption = QStringLiteral("accept-other-paper");

QString stateWord(const PrinterInfo& printer) {
    if (printer.state == PrinterState::Stopped) {
        return QStringLiteral("stopped");
    }
    if (!printer.acceptsJobs) {
        return QStringLiteral("does not accept jobs");
    }
    return printer.state == PrinterState::Printing ? QStringLiteral("printing")
                                                   : QStringLiteral("ready");
}

QString mediaWords(const PrinterMedia& media) {
    const QMarginsF& m = media.margins;
    const double margin = std::max({m.left(), m.top(), m.right(), m.bottom()});
    return QStringLiteral("%1 × %2 mm%3%4")
        .arg(media.size.width())
        .arg(media.size.height())
        .arg(margin > 0 ? QStringLiteral(", %1 mm margins").arg(margin)
                        : QStringLiteral(", borderless"),
             media.ready ? QString() : QStringLiteral(", not loaded"));
}

// Whether this program has made the PDF or TIFF file, which begins with `begin`. Qt writes the
// name of a PDF's creator in UTF-16, qpdf in ASCII. A TIFF names its software near its end.
bool isOwnSheet(const QString& path, const QByteArray& begin) {
    if (begin.startsWith("%PDF-")) {
        return begin.contains("/Creator (Dipwright ") ||
               begin.contains("/Creator <feff0044006900700077007200690067006800740020");
    }
    QFile file(path);
    const uchar* bytes =
        isTiff(path) && openToRead(file).isEmpty() ? file.map(0, file.size()) : nullptr;
    return bytes && QByteArray::fromRawData(reinterpret_cast<const char*>(bytes), file.size())
                        .contains("Dipwright ");
}

} // namespace

void declarePrinterOnly(CommandSyntax& syntax) {
    syntax.addOption({printerOption, QStringLiteral("The printer's name in the system."),
                      QStringLiteral("NAME")});
    syntax.addOption({profileOption,
                      QStringLiteral("The printer profile, instead of the one in the project."),
                      QStringLiteral("NAME")});
    syntax.addOption(
        {otherPaperOption,
         QStringLiteral("Prints even if the printer does not report the paper as loaded.")});
}

QString printerName(const QCommandLineParser& parser) {
    return parser.value(printerOption);
}

void declarePrinter(CommandSyntax& syntax, const QString& file) {
    declarePrinterOnly(syntax);
    syntax.addOption(
        {printersOption, QStringLiteral("Lists the printers with their state and papers.")});
    syntax.addOption({toOption,
                      file.isEmpty()
                          ? QStringLiteral("Writes a PDF or TIFF file in the printer's scale and "
                                           "colours instead of printing.")
                          : file,
                      QStringLiteral("FILE")});
}

bool acceptsOtherPaper(const QCommandLineParser& parser) {
    return parser.isSet(otherPaperOption);
}

bool listsPrinters(const QCommandLineParser& parser) {
    return parser.isSet(printersOption);
}

void listPrinters(QTextStream& out) {
    const auto system = printSystem();
    const QStringList names = system->printers();
    if (names.isEmpty()) {
        out << QStringLiteral("There are no printers; set one up in the system first\n");
    }
    for (const QString& name : names) {
        const auto printer = system->printer(name);
        if (!printer) {
            continue;
        }
        out << QStringLiteral("%1: %2, %3%4\n")
                   .arg(name, stateWord(*printer),
                        printer->printsColour ? QStringLiteral("colour")
                                              : QStringLiteral("grey only"),
                        printer->isDefault ? QStringLiteral(", default") : QString());
        for (const PrinterMedia& media : printer->media) {
            out << QStringLiteral("  %1: %2\n").arg(media.name, mediaWords(media));
        }
        if (const auto& custom = printer->customMedia) {
            out << QStringLiteral("  custom: any size from %1 × %2 mm to %3 × %4 mm\n")
                       .arg(custom->least.width())
                       .arg(custom->least.height())
                       .arg(custom->most.width())
                       .arg(custom->most.height());
        }
    }
}

bool namesTarget(const QCommandLineParser& parser) {
    return parser.isSet(printerOption) || parser.isSet(toOption);
}

void refuseTarget(const QCommandLineParser& parser, const QString& when) {
    refuseOptions(parser, {printerOption, toOption, otherPaperOption}, when);
}

PrintTarget printTarget(const QCommandLineParser& parser) {
    PrintTarget target{printerName(parser), parser.value(toOption)};
    if (target.printer.isEmpty() == target.file.isEmpty()) {
        throw UsageError(QStringLiteral("Name the printer with --printer NAME (--printers lists "
                                        "them), or a file with --to FILE"),
                         QStringLiteral("--printer"));
    }
    if (!target.file.isEmpty() && !isTiff(target.file) &&
        !target.file.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive)) {
        throw UsageError(QStringLiteral("The file must end in .pdf, .tif or .tiff"), target.file);
    }
    if (!target.file.isEmpty()) {
        requireReplaceableSheet(target.file);
    }
    return target;
}

void requireReplaceableSheet(const QString& path) {
    requireReplaceable(
        path, [&](const QByteArray& begin) { return isOwnSheet(path, begin); },
        QStringLiteral("a sheet or page of this program"));
}

void useProfile(const QCommandLineParser& parser, Project& project) {
    if (parser.isSet(profileOption)) {
        project.profiles.printer = std::get<PrinterProfile>(
            ProfileLibrary().profile(ProfileKind::Printer, parser.value(profileOption)));
    }
}

PrintRequest printRequest(const QCommandLineParser& parser, const PrintTarget& target,
                          const Project& project) {
    PrintRequest request;
    request.printer = target.printer;
    request.acceptOtherPaper = acceptsOtherPaper(parser);
    request.profile = project.profiles.printer;
    return request;
}

void printAndReport(PrintSystem& system, const std::vector<PrintPlan>& plans,
                    const Progress& progress, QTextStream& out) {
    const auto tell = [&](const PrintTask& task, const PrintJob& job, JobState state) {
        out << (state == JobState::Printed
                    ? QStringLiteral("Printed %1 on %2, job %3\n")
                          .arg(task.title, job.printer)
                          .arg(job.id)
                    : QStringLiteral("Sent %1 to %2, which does not report when it is printed\n")
                          .arg(task.title, job.printer));
        out.flush();
    };
    try {
        const PrintEnd end = printPlans(system, plans, PrintHistory(), progress, tell);
        if (!end.historyFailure.isEmpty()) {
            out << historyErrorText(end.historyFailure) << '\n';
        }
    } catch (const Cancelled&) {
        throw Error(QStringLiteral("Cancelled. The job was withdrawn, but pages that the printer "
                                   "has begun may still come out"),
                    plans.front().task.printer);
    }
}

} // namespace dipwright::cli
