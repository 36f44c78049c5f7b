#include "printing/PrintService.h"

#include "base/Bytes.h"
#include "base/Error.h"
#include "printing/PrintFile.h"
#include "printing/PrintReach.h"
#include "sheet/packing/FilmPacking.h"
#include "sheet/page/PaperMargins.h"
#include "sheet/page/SheetLayout.h"
#include "sheet/page/SheetRows.h"
#include "sheet/pdf/PdfDocument.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/SheetFiles.h"
#include "sheet/prepress/TiledSheet.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QSet>
#include <QThread>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Printing)
};

constexpr unsigned long pause = 200; // milliseconds between two queries about a job
constexpr double sameSize = 0.6;     // mm; rounding to whole points can change sizes this much

QString plain(double millimetres) {
    return QString::number(millimetres, 'g', 5);
}

QString plain(QSizeF size) {
    return Text::tr("%1 × %2 mm").arg(plain(size.width()), plain(size.height()));
}

bool isSame(QSizeF a, QSizeF b) {
    return std::abs(a.width() - b.width()) <= sameSize &&
           std::abs(a.height() - b.height()) <= sameSize;
}

bool holds(QSizeF paper, QSizeF page) {
    return page.width() <= paper.width() + sameSize && page.height() <= paper.height() + sameSize;
}

// Returns whether the printer scales pages by default. A page is as large as its paper, so IPP's
// "auto" and "auto-fit" do not scale it.
bool scalesUnasked(const PrinterInfo& printer) {
    const QStringList harmless{QString(), QStringLiteral("none"), QStringLiteral("auto"),
                               QStringLiteral("auto-fit")};
    return !harmless.contains(printer.scaling);
}

// Throws Error if the printer scales pages and the system cannot prevent that. Setting "none" in
// jobs is not enough: CUPS 2.4 does not pass it to printers that receive PDF. A printer that
// respects "none" gets the job directly, past its queue.
void checkScaling(const PrinterInfo& printer) {
    if (scalesUnasked(printer) && !printer.canForbidScaling) {
        throw Error(
            Text::tr("The printer scales pages by itself (\"%1\"), and the print system cannot "
                     "turn this off; set the scaling to \"none\" in the printer's own menu")
                .arg(printer.scaling),
            printer.name);
    }
}

PrinterInfo readyPrinter(PrintSystem& system, const QString& name) {
    const std::optional<PrinterInfo> printer = system.printer(name);
    if (!printer) {
        const QStringList names = system.printers();
        throw Error(names.isEmpty() ? Text::tr("There is no such printer, and no other printer is "
                                               "set up; set one up in the system first")
                                    : Text::tr("There is no such printer; choose one of: %1")
                                          .arg(names.join(QStringLiteral(", "))),
                    name);
    }
    const QString reason = printer->stateReason.isEmpty()
                               ? QString()
                               : QStringLiteral(" (%1)").arg(printer->stateReason);
    if (printer->state == PrinterState::Stopped) {
        throw Error(Text::tr("The printer is stopped%1; start it again in the system's settings")
                        .arg(reason),
                    name);
    }
    if (!printer->acceptsJobs) {
        throw Error(Text::tr("The printer does not accept jobs at the moment%1; allow jobs in the "
                             "system's settings")
                        .arg(reason),
                    name);
    }
    checkScaling(*printer);
    return *printer;
}

// Returns the medium of this size with the smallest margins, or null if there is none.
const PrinterMedia* mediaOfSize(const std::vector<PrinterMedia>& media, QSizeF size) {
    const PrinterMedia* best = nullptr;
    for (const PrinterMedia& one : media) {
        if (isSame(one.size, size) && (!best || widest(one.margins) < widest(best->margins))) {
            best = &one;
        }
    }
    return best;
}

QString sizeNames(const PrinterInfo& printer) {
    QStringList names;
    for (const PrinterMedia& one : printer.media) {
        names << plain(one.size);
    }
    names.removeDuplicates();
    constexpr int most = 8;
    if (names.size() > most) {
        names = names.mid(0, most) << QStringLiteral("…");
    }
    if (const auto& custom = printer.customMedia) {
        names << Text::tr("any size from %1 to %2").arg(plain(custom->least), plain(custom->most));
    }
    return names.join(QStringLiteral(", "));
}

struct PaperChoice {
    PrinterMedia media;
    bool turned = false;   // the page is rotated on the paper
    bool isCustom = false; // the paper has a size that the printer does not list
};

// Returns a paper for the page in a custom size, or nothing. It is loaded if the page fits on a
// loaded sheet or roll, or if the printer does not report what is loaded.
std::optional<PrinterMedia> customPaper(const PrinterInfo& printer, QSizeF page) {
    const std::optional<CustomMedia>& custom = printer.customMedia;
    if (!custom || !holds(custom->most, page) || !holds(page, custom->least)) {
        return std::nullopt;
    }
    const bool ready =
        custom->loaded.empty() ||
        std::ranges::any_of(custom->loaded, [&](QSizeF loaded) { return holds(loaded, page); });
    return PrinterMedia{QStringLiteral("custom"), page, custom->margins, ready};
}

// Returns a paper of the page's size, or else a custom size, on which the page lies as `turning`
// says.
std::optional<PaperChoice> findPaper(const PrinterInfo& printer, QSizeF page, Turning turning) {
    for (const bool turned : {false, true}) {
        if (const PrinterMedia* media =
                mediaOfSize(printer.media, turned ? page.transposed() : page)) {
            return PaperChoice{*media, turned};
        }
    }
    std::optional<PaperChoice> notLoaded;
    for (const bool turned : {false, true}) {
        if (turning == (turned ? Turning::Never : Turning::Always)) {
            continue;
        }
        if (const auto media = customPaper(printer, turned ? page.transposed() : page)) {
            if (media->ready) {
                return PaperChoice{*media, turned, true};
            }
            notLoaded = notLoaded ? notLoaded : PaperChoice{*media, turned, true};
        }
    }
    return notLoaded;
}

PaperChoice paperFor(const PrinterInfo& printer, QSizeF page, Turning turning = Turning::Allowed) {
    if (const std::optional<PaperChoice> found = findPaper(printer, page, turning)) {
        return *found;
    }
    const bool someHolds =
        std::any_of(printer.media.begin(), printer.media.end(), [&](const PrinterMedia& media) {
            return holds(media.size, page) || holds(media.size, page.transposed());
        });
    throw Error(
        someHolds
            ? Text::tr(
                  "The printer has no paper of %1; set the paper of the sheet to one of these: %2")
                  .arg(plain(page), sizeNames(printer))
            : Text::tr("The sheet of %1 is larger than every paper of the printer (%2); make it "
                       "smaller or print it in tiles")
                  .arg(plain(page), sizeNames(printer)),
        printer.name);
}

const PrinterMedia& tilePaper(const PrinterInfo& printer, const QString& name) {
    const PrinterMedia* best = nullptr;
    for (const PrinterMedia& media : printer.media) {
        const double area = media.size.width() * media.size.height();
        const bool larger = !best || area > best->size.width() * best->size.height();
        if (name.isEmpty() ? larger && media.ready : media.name == name) {
            best = &media;
        }
    }
    if (!best) {
        throw Error(
            name.isEmpty()
                ? Text::tr("The printer reports no loaded paper for the tiles; load paper, or "
                           "choose a paper for the tiles")
                : Text::tr("The printer has no paper named %1; choose another paper").arg(name),
            printer.name);
    }
    return *best;
}

bool isColoured(const Sheet& sheet) {
    bool isGrey = true;
    forSheetRows(sheet, [&](const Sheet& rows, int) {
        const QImage pixels = rows.image.convertToFormat(QImage::Format_RGBA8888);
        for (int y = 0; y < pixels.height() && isGrey; ++y) {
            const uchar* pixel = pixels.constScanLine(y);
            for (int x = 0; x < pixels.width(); ++x, pixel += 4) {
                isGrey &= pixel[3] == 0 || (pixel[0] == pixel[1] && pixel[1] == pixel[2]);
            }
        }
    });
    return !isGrey;
}

void checkColour(const PrinterInfo& printer, const Sheet& sheet, const PrintRequest& request,
                 QStringList& warnings) {
    if (printer.printsColour || !isColoured(sheet)) {
        return;
    }
    if (!request.acceptMonochrome) {
        throw Error(
            Text::tr("The printer prints in grey only, and the sheet is coloured; choose a colour "
                     "printer, or accept grey"),
            printer.name);
    }
    warnings << Text::tr("The printer prints the coloured sheet in grey");
}

void checkLoaded(const PrinterInfo& printer, const PrinterMedia& media, const PrintRequest& request,
                 QStringList& warnings) {
    if (media.ready) {
        return;
    }
    const QString sentence =
        Text::tr("The printer has no paper of %1 loaded").arg(plain(media.size));
    if (!request.acceptOtherPaper) {
        throw Error(Text::tr("%1; load it, or choose other paper").arg(sentence), printer.name);
    }
    warnings << sentence;
}

void addressTask(PrintPlan& plan) {
    plan.task.printer = plan.printer.name;
    plan.task.pastQueue = scalesUnasked(plan.printer);
    if (plan.task.pastQueue) {
        plan.warnings << Text::tr(
            "The printer scales pages by default, and its queue cannot turn this off; the job "
            "bypasses the queue and goes directly to the printer");
    }
}

void fillTiled(PrintTask& task, const Sheet& sheet, const QMarginsF& lost,
               const PrintCorrection& correction) {
    const TileSettings settings = tileSettings(task.media.size, lost);
    const std::vector<SheetTile> tiles = sheetTiles(sheet, settings);
    task.pages = int(tiles.size());
    task.pdf =
        bytesOf([&](QIODevice& device) { writeTiledPdf(sheet, settings, device, correction); });
    const PrintCorrection scales{correction.scaleX, correction.scaleY};
    task.paint = [sheet, settings, scales, tiles](QPainter& painter, int page) {
        correctScale(painter, settings.paper, scales);
        paintTile(painter, sheet, settings, tiles.at(std::size_t(page)));
    };
}

void fillWhole(PrintTask& task, const Sheet& sheet, PrintCorrection correction) {
    task.pdf = bytesOf([&](QIODevice& device) { writeSheetPdf(sheet, device, correction); });
    correction.colour = nullptr;
    task.paint = [sheet, correction](QPainter& painter, int) {
        paintCorrectedSheet(painter, sheet, correction);
    };
}

void repeat(PrintTask& task, int copies) {
    task.pdf = repeatedPdf(task.pdf, copies);
    task.paint = [paint = task.paint, pages = task.pages](QPainter& painter, int page) {
        paint(painter, page % pages);
    };
    task.pages *= copies;
}

QString stateText(const JobStatus& status, const QString& printerReason) {
    const QString state = status.state == JobState::Printing ? Text::tr("Printing")
                          : status.state == JobState::Held
                              ? Text::tr("Held in the printer's queue")
                              : Text::tr("Waiting in the printer's queue");
    const QString reason = printerReason.isEmpty() ? status.reason : printerReason;
    return reason.isEmpty() ? state : QStringLiteral("%1: %2").arg(state, reason);
}

// Stores a print's record in the history: once when the print is sent, and again when it ends.
class RecordedPrint {
public:
    RecordedPrint(const PrintHistory& history, const std::optional<PrintRecord>& record)
        : history_(history), record_(record) {
        keep();
    }
    void end(PrintOutcome fate, const QString& reason = {}) {
        if (record_) {
            record_->fate = fate;
            record_->reason = reason;
            keep();
        }
    }
    const QString& historyFailure() const { return historyFailure_; }

private:
    void keep() {
        if (record_) {
            historyFailure_ = history_.keep(*record_);
        }
    }

    const PrintHistory& history_;
    std::optional<PrintRecord> record_;
    QString historyFailure_;
};

// Cancels a job. Returns a phrase that says whether the job is known to be cancelled.
QString cancelAndDescribe(PrintSystem& system, const PrintJob& job) {
    constexpr int questions = 10;
    system.cancel(job);
    for (int i = 0; i < questions; ++i) {
        const JobState state = system.status(job).state;
        if (state == JobState::Cancelled || state == JobState::Failed) {
            return Text::tr("the job was cancelled");
        }
        QThread::msleep(pause);
    }
    return Text::tr("the job could not be cancelled, so remove it from the printer's queue");
}

// Returns the final state of a job, or nothing while the job continues. Throws NotPrinted if it
// failed.
std::optional<JobState> endOf(PrintSystem& system, const PrintJob& job, const JobStatus& status,
                              const std::optional<PrinterInfo>& printer) {
    const QString reason =
        status.reason.isEmpty() ? Text::tr("no reason was given") : status.reason;
    switch (status.state) {
    case JobState::Printed:
        if (printer && !printer->reportsPrinted && !printer->answers) {
            throw NotPrinted(
                PrintOutcome::Unknown,
                Text::tr("The print system has finished the job, but the printer does not answer; "
                         "check whether the sheet was printed, and print it again if not"),
                job.printer);
        }
        return printer && !printer->reportsPrinted ? JobState::HandedOver : JobState::Printed;
    case JobState::HandedOver:
        return JobState::HandedOver;
    case JobState::Cancelled:
        throw NotPrinted(PrintOutcome::Cancelled, Text::tr("The job was cancelled at the printer"),
                         job.printer);
    case JobState::Failed:
        throw NotPrinted(PrintOutcome::Failed,
                         Text::tr("The printer aborted the job: %1").arg(reason), job.printer);
    case JobState::Stopped:
        system.cancel(job);
        throw NotPrinted(PrintOutcome::Stopped,
                         Text::tr("The printer stopped in the middle of the job: %1; the rest was "
                                  "cancelled, so print the sheet again")
                             .arg(reason),
                         job.printer);
    case JobState::Waiting:
    case JobState::Held:
    case JobState::Printing:
        break;
    }
    if (printer && printer->state == PrinterState::Stopped) {
        system.cancel(job);
        throw NotPrinted(PrintOutcome::Stopped,
                         Text::tr("The printer has stopped: %1; the job was cancelled, so start "
                                  "the printer and print the sheet again")
                             .arg(printer->stateReason.isEmpty() ? reason : printer->stateReason),
                         job.printer);
    }
    return std::nullopt;
}

// Limits how long the program waits for an unfinished job.
class Patience {
public:
    explicit Patience(std::chrono::milliseconds patience) : patience_(patience) {
        sinceNews_.start();
    }
    // Throws NotPrinted if the time is up. `message` is the current message about the job.
    void wait(PrintSystem& system, const PrintJob& job, const JobStatus& status,
              const std::optional<PrinterInfo>& printer, const QString& message) {
        updateSilence(status, printer);
        if (silence_.isValid() && silence_.hasExpired(patience_.count())) {
            throw NotPrinted(
                PrintOutcome::Stopped,
                Text::tr("The printer does not answer (%1); %2; check its power, its cable and its "
                         "address in the system, and print the sheet again")
                    .arg(message, cancelAndDescribe(system, job)),
                job.printer);
        }
        if (!messages_.contains(message)) {
            messages_.insert(message);
            sinceNews_.start();
        }
        if (printer && !printer->reportsPrinted && status.state == JobState::Printing &&
            sinceNews_.hasExpired(10 * patience_.count())) {
            throw NotPrinted(PrintOutcome::Unknown,
                             Text::tr("The state of job %1 has not changed for a long time (%2), "
                                      "and this printer cannot be queried; check the printer, and "
                                      "remove the job from its queue if it does not print")
                                 .arg(job.id)
                                 .arg(message),
                             job.printer);
        }
    }

private:
    // If a job waits while its printer is idle, the queue will send it again. Between these
    // attempts, the queue may report a state; that does not count as an answer of the printer.
    void updateSilence(const JobStatus& status, const std::optional<PrinterInfo>& printer) {
        const bool isAnswering =
            printer && printer->answers &&
            !(status.state == JobState::Waiting && printer->state == PrinterState::Idle);
        if (!isAnswering) {
            answers_.invalidate();
        } else if (!answers_.isValid()) {
            answers_.start();
        }
        if (isAnswering && answers_.hasExpired(patience_.count() / 4)) {
            silence_.invalidate();
        } else if (!isAnswering && !silence_.isValid()) {
            silence_.start();
        }
    }

    std::chrono::milliseconds patience_;
    QElapsedTimer silence_, answers_; // valid while the printer is silent, or while it answers
    QElapsedTimer sinceNews_;
    QSet<QString> messages_;
};

} // namespace

PrintPlan planPrint(PrintSystem& system, const Sheet& unnumbered, const PrintRequest& request) {
    const Sheet original = numberedFor(request.profile, unnumbered);
    PrintPlan plan;
    plan.printer = readyPrinter(system, request.printer);
    checkColour(plan.printer, original, request, plan.warnings);
    // Packed films are laid out for the direction of their web.
    const Turning turning = original.pieces.empty() ? request.turning : Turning::Never;
    const std::optional<PaperChoice> whole = findPaper(plan.printer, pageSize(original), turning);
    const bool tiled = request.tile && (!request.tilePaper.isEmpty() || !whole ||
                                        (whole->isCustom && !whole->media.ready));
    const PaperChoice paper = tiled ? PaperChoice{tilePaper(plan.printer, request.tilePaper), false}
                                    : paperFor(plan.printer, pageSize(original), turning);
    checkLoaded(plan.printer, paper.media, request, plan.warnings);
    const std::unique_ptr<PrinterColour> colour = printerColour(request.profile);
    PrintCorrection correction = printCorrection(request.profile, colour.get());
    plan.warnings += leftOut(original, correction, false);
    addressTask(plan);
    plan.task.title =
        QStringLiteral("%1 – %2").arg(original.job.project, original.job.immersion).simplified();
    plan.task.media = paper.media;
    const QMarginsF margins = unreachable(paper.media.margins, request.profile);
    if (tiled) {
        fillTiled(plan.task, original, clippedEdges(paper.media.size, margins, correction),
                  correction);
    } else {
        correction.acrossPaper = paper.turned;
        const Sheet sheet = withinReach(original, margins, correction, request.acceptClipping,
                                        request.printer, plan.warnings);
        fillWhole(plan.task, sheet, correction);
    }
    if (request.copies > 1) {
        repeat(plan.task, request.copies);
    }
    plan.record = recordOf(original, request.source, request.profile, paper.media.size);
    plan.record->printer = request.printer;
    plan.record->mediumName = paper.media.name;
    plan.record->copies = request.copies;
    return plan;
}

std::optional<QSizeF> rollSize(const PrinterInfo& printer,
                               const std::optional<PrinterProfile>& profile) {
    const std::optional<CustomMedia>& custom = printer.customMedia;
    if (!custom) {
        return std::nullopt;
    }
    double width = 0;
    for (const QSizeF& loaded : custom->loaded) {
        width = std::max(width, std::min(loaded.width(), custom->most.width()));
    }
    if (profile && profile->rollWidth) {
        width = profile->rollWidth->value();
    }
    return QSizeF(width > 0 ? width : custom->most.width(),
                  std::min(custom->most.height(), mostFilmLength));
}

QMarginsF printerMargins(PrintSystem& system, const QString& printer, const PackingFilm& film) {
    const PrinterInfo info = readyPrinter(system, printer);
    if (film.isRoll) {
        return info.customMedia ? info.customMedia->margins : QMarginsF();
    }
    const std::optional<PaperChoice> paper = findPaper(info, film.size, Turning::Never);
    if (!paper) {
        return {};
    }
    const QMarginsF& m = paper->media.margins; // of a turned page, the left edge is the top edge
    return paper->turned ? QMarginsF(m.top(), m.right(), m.bottom(), m.left()) : m;
}

namespace {

// Returns the roll for a series of sheets, or nothing if the sheets are printed one by one.
std::optional<PackingFilm> rollFor(PrintSystem& system, const std::vector<Sheet>& sheets,
                                   const PrintRequest& request) {
    const bool areSingle = std::any_of(sheets.begin(), sheets.end(), [](const Sheet& sheet) {
        return !sheet.pieces.empty() || sheet.passes > 1; // packed, or fed again for each pass
    });
    if (areSingle || request.tile || !request.profile || !request.profile->rollGap) {
        return std::nullopt;
    }
    const PrinterInfo printer = readyPrinter(system, request.printer);
    const std::optional<QSizeF> size = rollSize(printer, request.profile);
    if (!size) {
        return std::nullopt;
    }
    PackingFilm roll;
    roll.size = *size;
    roll.isRoll = roll.wholeSheets = true;
    roll.spacing = *request.profile->rollGap;
    return withinReach(roll, printer.customMedia->margins, request.profile);
}

// Returns all copies of the sheets on a roll. Each result is one page.
std::vector<Sheet> seriesOn(const PackingFilm& roll, const std::vector<Sheet>& sheets,
                            const PrintRequest& request) {
    std::vector<PieceToPack> pieces;
    for (const Sheet& sheet : sheets) {
        pieces.push_back({sheet, int(pieces.size()) + 1, request.copies, request.turning});
    }
    const FilmPlan plan = planFilms(pieces, roll);
    std::vector<Sheet> films;
    for (std::size_t number = 0; number < plan.films.size(); ++number) {
        films.push_back(filmSheet(pieces, roll, plan, number));
    }
    return films;
}

} // namespace

std::vector<PrintPlan> planPrints(PrintSystem& system, const std::vector<Sheet>& sheets,
                                  const PrintRequest& request) {
    std::vector<PrintPlan> plans;
    if (const std::optional<PackingFilm> roll = rollFor(system, sheets, request)) {
        PrintRequest once = request;
        once.copies = 1;
        for (const Sheet& film : seriesOn(*roll, sheets, request)) {
            plans.push_back(planPrint(system, film, once));
            plans.back().warnings.prepend(
                Text::tr("Series on the roll, %1, with cut marks; sheets: %2")
                    .arg(plain(plans.back().task.media.size))
                    .arg(film.pieces.size()));
        }
        return plans;
    }
    for (const Sheet& sheet : sheets) {
        plans.push_back(planPrint(system, sheet, request));
    }
    return plans;
}

PrintPlan planCalibration(PrintSystem& system, const CalibrationPage& page,
                          const PrintRequest& request) {
    PrintPlan plan;
    plan.printer = readyPrinter(system, request.printer);
    const PaperChoice paper = paperFor(plan.printer, page.paper);
    if (paper.turned) {
        throw Error(Text::tr("The printer feeds this paper only with its other edge first; rotate "
                             "the page by 90°"),
                    request.printer);
    }
    checkLoaded(plan.printer, paper.media, request, plan.warnings);
    const double margin = widest(paper.media.margins);
    if (margin > page.clearance.value()) {
        throw Error(Text::tr("The printer does not reach the outer %1 mm of the paper; enter the "
                             "printer's margins in its profile first")
                        .arg(plain(margin)),
                    request.printer);
    }
    addressTask(plan);
    plan.task.title = Text::tr("Calibration of %1").arg(page.printer);
    plan.task.media = paper.media;
    plan.task.pdf = bytesOf([&](QIODevice& device) { writeCalibrationPdf(page, device); });
    plan.task.paint = [page](QPainter& painter, int) {
        correctScale(painter, page.paper, {page.scaleX, page.scaleY});
        paintCalibrationPage(painter, page);
    };
    return plan;
}

JobState followJob(PrintSystem& system, const PrintJob& job, const Progress& progress,
                   std::chrono::milliseconds patience) {
    Patience waiting(patience);
    try {
        for (;;) {
            const JobStatus status = system.status(job);
            const std::optional<PrinterInfo> printer = system.printer(job.printer);
            if (const auto end = endOf(system, job, status, printer)) {
                return *end;
            }
            const QString message = stateText(status, printer ? printer->stateReason : QString());
            waiting.wait(system, job, status, printer, message);
            progress(status.state == JobState::Printing ? 0.5 : 0.1, message);
            QThread::msleep(pause);
        }
    } catch (const Cancelled&) {
        system.cancel(job);
        throw;
    }
}

PrintEnd printPlans(PrintSystem& system, const std::vector<PrintPlan>& plans,
                    const PrintHistory& history, const Progress& progress,
                    const JobEndObserver& ended) {
    const double share = 1.0 / double(plans.size());
    double done = 0;
    PrintEnd end;
    for (const PrintPlan& plan : plans) {
        progress.cancelToken.throwIfCancelled();
        RecordedPrint kept(history, plan.record);
        PrintOutcome ifNot = PrintOutcome::Failed;
        try {
            const PrintJob job = system.submit(plan.task);
            ifNot = PrintOutcome::Unknown;
            end.state = followJob(system, job, progress.part(done, done + share));
            kept.end(end.state == JobState::Printed ? PrintOutcome::Printed
                                                    : PrintOutcome::HandedOver);
            if (ended) {
                ended(plan.task, job, end.state);
            }
        } catch (const Cancelled&) {
            kept.end(PrintOutcome::Cancelled);
            throw;
        } catch (const NotPrinted& error) {
            kept.end(error.fate(), error.message());
            throw;
        } catch (const Error& error) {
            kept.end(ifNot, error.message());
            throw;
        }
        if (!kept.historyFailure().isEmpty()) {
            end.historyFailure = kept.historyFailure();
        }
        done += share;
    }
    return end;
}

} // namespace dipwright
