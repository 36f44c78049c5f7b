// The printing of the operating system: printers and jobs. Each platform has a small
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
    QString name;      // in the system
    QSizeF size;       // mm, in feed direction
    QMarginsF margins; // mm; unprintable
    bool ready = true; // loaded, according to the printer
};

enum class PrinterState { Idle, Printing, Stopped };

struct PrinterInfo {
    QString name;
    QString description; // for the user
    bool isDefault = false;
    PrinterState state = PrinterState::Idle;
    QString stateReason; // the printer's explanation of its state, or empty
    bool acceptsJobs = true;
    bool printsColour = true;
    // What the printer does to a page's size by default, in IPP's words ("none", "fit" …). Empty if
    // it does not report that.
    QString scaling;
    bool takesTrueSize = false; // past its queue: respects a PDF job that forbids scaling
    bool answers = true; // the printer itself, not only its queue, as far as it can be queried
    // Whether the printer itself reports that a job is printed. Otherwise only its queue does,
    // which only knows that the job was sent.
    bool tellsPrinted = true;
    std::vector<PrinterMedia> media;
};

// One job: pages of one size, as a PDF and as a paint function. The system uses one of them; both
// have the same content with corrected scales.
struct PrintTask {
    QString printer;
    QString title;
    PrinterMedia media;
    QByteArray pdf;
    int pages = 1;                             // copies included
    std::function<void(QPainter&, int)> paint; // paints a page, with a painter in mm
    // Send it directly to the printer, because its queue does not pass on that pages must not be
    // scaled.
    bool pastQueue = false;
};

struct PrintJob {
    QString printer;
    int id = 0;             // in the queue …
    bool pastQueue = false; // … or in the printer
};

enum class JobState { Waiting, Held, Printing, Stopped, Printed, HandedOver, Cancelled, Failed };

struct JobStatus {
    JobState state = JobState::Waiting;
    QString reason; // in the system's words, or empty
};

// Calls may block for as long as the printer takes to answer. Use one object from one thread.
// Members throw Error when the system does not answer.
class PrintSystem {
public:
    virtual ~PrintSystem() = default;

    // Names of the printers, sorted.
    virtual QStringList printers() = 0;
    // Queries the printer now. Nothing if there is no printer of that name.
    virtual std::optional<PrinterInfo> printer(const QString& name) = 0;
    // Submits a job with its media and without scaling.
    virtual PrintJob submit(const PrintTask& task) = 0;
    virtual JobStatus status(const PrintJob& job) = 0;
    virtual void cancel(const PrintJob& job) = 0;
};

// The best implementation on this platform: CUPS, else Qt. Throws Error if the program was built
// with neither.
std::unique_ptr<PrintSystem> printSystem();

// The portable route through QPrinter. It sends paintings instead of PDF and cannot follow a job
// beyond the system's queue (JobState::HandedOver). Null if the program was built without it.
std::unique_ptr<PrintSystem> qtPrintSystem();
// Null if the program was built without CUPS.
std::unique_ptr<PrintSystem> cupsPrintSystem();

} // namespace dipwright
