// Gives access to the operating system's printers and print jobs. Each platform has a small
// implementation; all checks and decisions are in PrintService.h.
#pragma once

#include <QByteArray>
#include <QMarginsF>
#include <QPainter>
#include <QSizeF>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace dipwright {

// A paper of one printer. The same paper may exist with and without margins.
struct PrinterMedia {
    QString name;      // the paper's name in the system
    QSizeF size;       // width and height in feed direction, mm
    QMarginsF margins; // unprintable margins, mm
    bool ready = true; // the printer reports this paper as loaded
    bool operator==(const PrinterMedia&) const = default;
};

// Sizes that a printer accepts besides its papers, as roll printers do.
struct CustomMedia {
    QSizeF least, most; // mm, in feed direction
    QMarginsF margins;  // unprintable margins, mm
    // Sizes of the sheets and rolls that the printer reports as loaded; empty: it reports none.
    std::vector<QSizeF> loaded;
};

enum class PrinterState { Idle, Printing, Stopped };

struct PrinterInfo {
    QString name;
    QString description; // for the user
    bool isDefault = false;
    PrinterState state = PrinterState::Idle;
    QString stateReason; // the printer's explanation of its state, may be empty
    bool acceptsJobs = true;
    bool printsColour = true;
    // The printer's default scaling of pages, in IPP's words ("none", "fit" …). Empty if the
    // printer does not report it.
    QString scaling;
    // Whether a PDF job that goes directly to the printer can forbid scaling.
    bool canForbidScaling = false;
    // Whether the printer itself answers, not only its queue. True if the printer cannot be tested.
    bool answers = true;
    // Whether the printer itself reports that a job is printed. Otherwise only its queue reports
    // that the job was sent.
    bool reportsPrinted = true;
    std::vector<PrinterMedia> media;
    std::optional<CustomMedia> customMedia; // none if the printer has only fixed sizes
};

// One job: pages of one size, both as a PDF and as a paint function. The system uses one of the
// two. Both have the same content with corrected scales.
struct PrintTask {
    QString printer;
    QString title;
    PrinterMedia media;
    QByteArray pdf;
    int pages = 1;                             // number of pages, including copies
    std::function<void(QPainter&, int)> paint; // paints one page with a painter in mm
    // Whether to send the job directly to the printer, because the queue does not pass on that
    // pages must not be scaled.
    bool pastQueue = false;
};

struct PrintJob {
    QString printer;
    int id = 0; // the job's number in the queue, or in the printer if `pastQueue` is set
    bool pastQueue = false; // the job was sent directly to the printer
};

enum class JobState { Waiting, Held, Printing, Stopped, Printed, HandedOver, Cancelled, Failed };

struct JobStatus {
    JobState state = JobState::Waiting;
    QString reason; // the reason in the system's words, may be empty
};

// Calls may block until the printer answers. One object may only be used by one thread. Members
// throw Error if the system does not answer.
class PrintSystem {
public:
    virtual ~PrintSystem() = default;

    // Returns the names of the printers, sorted.
    virtual QStringList printers() = 0;
    // Queries the printer now. Returns nothing if there is no printer of that name.
    virtual std::optional<PrinterInfo> printer(const QString& name) = 0;
    // Submits a job with its media and without scaling.
    virtual PrintJob submit(const PrintTask& task) = 0;
    virtual JobStatus status(const PrintJob& job) = 0;
    virtual void cancel(const PrintJob& job) = 0;
};

// Returns the best implementation on this platform: CUPS, else Qt. Throws Error if the program was
// built with neither.
std::unique_ptr<PrintSystem> printSystem();

// Returns the portable implementation, which uses QPrinter. It sends paintings instead of PDF, and
// cannot follow a job beyond the system's queue (JobState::HandedOver). Returns null if the program
// was built without it.
std::unique_ptr<PrintSystem> qtPrintSystem();
// Returns the CUPS implementation, or null if the program was built without CUPS.
std::unique_ptr<PrintSystem> cupsPrintSystem();

} // namespace dipwright
