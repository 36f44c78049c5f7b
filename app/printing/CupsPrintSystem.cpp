// Prints through CUPS and IPP. No other file depends on these libraries.
#include "printing/PrintSystem.h"

#include "base/Error.h"
#include "base/Units.h"
#include "printing/PrintReach.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QSet>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <cups/cups.h>
#include <string_view>
#include <sys/socket.h>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Printing)
};

struct FreeDest {
    void operator()(cups_dest_t* dest) const { cupsFreeDests(1, dest); }
};
using Dest = std::unique_ptr<cups_dest_t, FreeDest>;

struct FreeInfo {
    void operator()(cups_dinfo_t* info) const { cupsFreeDestInfo(info); }
};
using DestInfo = std::unique_ptr<cups_dinfo_t, FreeInfo>;

struct FreeMessage {
    void operator()(ipp_t* message) const { ippDelete(message); }
};
using Message = std::unique_ptr<ipp_t, FreeMessage>;

// Options by which a queue may alter a sheet, with the values that turn them off.
constexpr std::pair<const char*, const char*> trueSizeOptions[] = {
    {"print-scaling", "none"},  {"fit-to-page", "false"},
    {"number-up", "1"},         {"sides", "one-sided"},
    {"mirror", "false"},        {"copies", "1"},
    {"job-sheets", "none"},     {"orientation-requested", "3"},
    {"output-order", "normal"},
};

QByteArray trueSizeOption(std::string_view name) {
    for (const auto& [option, value] : trueSizeOptions) {
        if (option == name) {
            return value;
        }
    }
    return {};
}

// Owns the list of a job's options.
class Options {
public:
    ~Options() { cupsFreeOptions(count_, options_); }
    void add(const char* name, const QByteArray& value) {
        count_ = cupsAddOption(name, value.constData(), count_, &options_);
    }
    int count() const { return count_; }
    cups_option_t* data() const { return options_; }

private:
    int count_ = 0;
    cups_option_t* options_ = nullptr;
};

QString lastMessage() {
    return QString::fromUtf8(cupsLastErrorString());
}

Dest namedDest(const QString& name) {
    return Dest(cupsGetNamedDest(CUPS_HTTP_DEFAULT, name.toUtf8().constData(), nullptr));
}

QString option(const Dest& dest, const char* name) {
    return QString::fromUtf8(cupsGetOption(name, dest->num_options, dest->options));
}

// Makes IPP reasons such as "media-empty-error" readable. Removes "none" and the reasons that CUPS
// itself adds.
QString readableReasons(const QString& reasons) {
    QStringList words;
    for (QString reason : reasons.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        if (reason != QLatin1String("none") && !reason.startsWith(QLatin1String("cups-"))) {
            words << reason.replace(QLatin1Char('-'), QLatin1Char(' '));
        }
    }
    return words.join(QStringLiteral(", "));
}

PrinterState stateOf(const QString& state) {
    return state == QLatin1String("5")   ? PrinterState::Stopped
           : state == QLatin1String("4") ? PrinterState::Printing
                                         : PrinterState::Idle;
}

// CUPS measures sizes in hundredths of a millimetre.
PrinterMedia mediaOf(const cups_size_t& size) {
    return {
        QString::fromUtf8(size.media), QSizeF(size.width / 100.0, size.length / 100.0),
        QMarginsF(size.left / 100.0, size.top / 100.0, size.right / 100.0, size.bottom / 100.0)};
}

// Describes the paper by size and margins. If it is described by name, some queues use
// "…_borderless" for the paper with margins.
QByteArray collection(const PrinterMedia& media) {
    const auto hundredths = [](double millimetres) {
        return QString::number(std::lround(millimetres * 100));
    };
    return QStringLiteral("{media-size={x-dimension=%1 y-dimension=%2} media-left-margin=%3 "
                          "media-top-margin=%4 media-right-margin=%5 media-bottom-margin=%6}")
        .arg(hundredths(media.size.width()), hundredths(media.size.height()),
             hundredths(media.margins.left()), hundredths(media.margins.top()),
             hundredths(media.margins.right()), hundredths(media.margins.bottom()))
        .toUtf8();
}

void addMedia(std::vector<PrinterMedia>& media, cups_dest_t* dest, cups_dinfo_t* info,
              unsigned flags) {
    const int count = cupsGetDestMediaCount(CUPS_HTTP_DEFAULT, dest, info, flags);
    for (int index = 0; index < count; ++index) {
        cups_size_t size{};
        if (cupsGetDestMediaByIndex(CUPS_HTTP_DEFAULT, dest, info, index, flags, &size)) {
            const PrinterMedia one = mediaOf(size);
            if (std::find(media.begin(), media.end(), one) == media.end()) {
                media.push_back(one);
            }
        }
    }
}

// Returns the size in a name such as "custom_max_610x3000mm" or "custom_min_4x2in" (PWG 5101.1).
std::optional<QSizeF> customSize(const QString& name, const char* end) {
    static const QRegularExpression pattern(
        QStringLiteral("^custom_(min|max)_([0-9.]+)x([0-9.]+)(mm|in)$"));
    const QRegularExpressionMatch match = pattern.match(name);
    if (!match.hasMatch() || match.captured(1) != QLatin1String(end)) {
        return std::nullopt;
    }
    const double unit = match.captured(4) == QLatin1String("in") ? millimetresPerInch : 1;
    return QSizeF(match.captured(2).toDouble(), match.captured(3).toDouble()) * unit;
}

// The margins of custom sizes are not reported separately. The result has the widest margins of the
// printer's papers.
std::optional<CustomMedia> customMediaOf(const PrinterInfo& printer, cups_dest_t* dest,
                                         cups_dinfo_t* info) {
    std::optional<QSizeF> least, most;
    ipp_attribute_t* names = cupsFindDestSupported(CUPS_HTTP_DEFAULT, dest, info, CUPS_MEDIA);
    for (int i = 0; i < (names ? ippGetCount(names) : 0); ++i) {
        const QString name = QString::fromUtf8(ippGetString(names, i, nullptr));
        least = least ? least : customSize(name, "min");
        most = most ? most : customSize(name, "max");
    }
    if (!least || !most) {
        return std::nullopt;
    }
    CustomMedia custom{*least, *most, {}, {}};
    for (const PrinterMedia& media : printer.media) {
        custom.margins = larger(custom.margins, media.margins);
    }
    return custom;
}

constexpr int connectionTimeout = 3000; // milliseconds, longest wait for a connection

// Returns whether the device speaks IPP and can be queried. A device that does not would print the
// query as text.
bool speaksIpp(const QString& uri) {
    return uri.startsWith(QLatin1String("ipp")) || uri.contains(QLatin1String("._ipp"));
}

struct CloseConnection {
    void operator()(http_t* connection) const { httpClose(connection); }
};
using Connection = std::unique_ptr<http_t, CloseConnection>;

// What only the printer itself can report. Its queue only reports its own defaults.
struct DeviceReport {
    // Sizes of the loaded papers, mm; empty if the printer does not report them.
    std::vector<QSizeF> loaded;
    QString scaling;
    bool canForbidScaling = false; // whether PDF jobs can forbid scaling
    QString stateReason;
    bool answers = false;
};

// A direct connection to a printer, and the printer's resource path on this connection.
struct Device {
    Connection connection;
    QByteArray resource, uri;
};

Device deviceOf(cups_dest_t* dest) {
    std::vector<char> resource(1024, '\0');
    Device device{
        Connection(cupsConnectDest(dest, CUPS_DEST_FLAGS_DEVICE, connectionTimeout, nullptr,
                                   resource.data(), resource.size(), nullptr, nullptr)),
        resource.data(),
        {}};
    if (device.connection) {
        http_t* http = device.connection.get();
        std::vector<char> uri(2048, '\0');
        std::vector<char> host(256, '\0');
        httpGetHostname(http, host.data(), int(host.size()));
        httpAssembleURI(HTTP_URI_CODING_ALL, uri.data(), int(uri.size()),
                        httpIsEncrypted(http) ? "ipps" : "ipp", nullptr, host.data(),
                        httpAddrPort(httpGetAddress(http)), resource.data());
        device.uri = uri.data();
    }
    return device;
}

// Returns a request, which cupsDoRequest frees.
ipp_t* deviceRequest(ipp_op_t operation, const Device& device) {
    ipp_t* request = ippNewRequest(operation);
    ippAddString(request, IPP_TAG_OPERATION, IPP_TAG_URI, "printer-uri", nullptr,
                 device.uri.constData());
    ippAddString(request, IPP_TAG_OPERATION, IPP_TAG_NAME, "requesting-user-name", nullptr,
                 cupsUser());
    return request;
}

QStringList keywordsOf(ipp_t* answer, const char* name, ipp_tag_t tag = IPP_TAG_KEYWORD) {
    QStringList words;
    ipp_attribute_t* attribute = ippFindAttribute(answer, name, tag);
    for (int i = 0; attribute && i < ippGetCount(attribute); ++i) {
        words << QString::fromUtf8(ippGetString(attribute, i, nullptr));
    }
    return words;
}

// Returns a dimension in mm. For a roll it is a range; the result is then its upper end. 0 if there
// is no such dimension.
double largestOf(ipp_t* size, const char* dimension) {
    if (!size) {
        return 0;
    }
    if (ipp_attribute_t* number = ippFindAttribute(size, dimension, IPP_TAG_INTEGER)) {
        return ippGetInteger(number, 0) / 100.0;
    }
    int upper = 0;
    if (ipp_attribute_t* range = ippFindAttribute(size, dimension, IPP_TAG_RANGE)) {
        ippGetRange(range, 0, &upper);
    }
    return upper / 100.0;
}

std::vector<QSizeF> sizesOf(ipp_attribute_t* media) {
    std::vector<QSizeF> sizes;
    for (int i = 0; media && i < ippGetCount(media); ++i) {
        ipp_attribute_t* size =
            ippFindAttribute(ippGetCollection(media, i), "media-size", IPP_TAG_BEGIN_COLLECTION);
        ipp_t* parts = size ? ippGetCollection(size, 0) : nullptr;
        const double x = largestOf(parts, "x-dimension");
        const double y = largestOf(parts, "y-dimension");
        if (x > 0 && y > 0) {
            sizes.emplace_back(x, y);
        }
    }
    return sizes;
}

DeviceReport wordOfDevice(cups_dest_t* dest) {
    const Device device = deviceOf(dest);
    if (!device.connection) {
        return {};
    }
    ipp_t* request = deviceRequest(IPP_OP_GET_PRINTER_ATTRIBUTES, device);
    const char* const wanted[] = {"media-col-ready", "print-scaling-default",
                                  "print-scaling-supported", "document-format-supported",
                                  "printer-state-reasons"};
    ippAddStrings(request, IPP_TAG_OPERATION, IPP_TAG_KEYWORD, "requested-attributes",
                  int(std::size(wanted)), nullptr, wanted);
    const Message answer(
        cupsDoRequest(device.connection.get(), request, device.resource.constData()));
    if (!answer) {
        return {};
    }
    DeviceReport word;
    word.loaded =
        sizesOf(ippFindAttribute(answer.get(), "media-col-ready", IPP_TAG_BEGIN_COLLECTION));
    word.scaling = keywordsOf(answer.get(), "print-scaling-default").value(0);
    word.canForbidScaling =
        keywordsOf(answer.get(), "print-scaling-supported").contains(QLatin1String("none")) &&
        keywordsOf(answer.get(), "document-format-supported", IPP_TAG_MIMETYPE)
            .contains(QLatin1String(CUPS_FORMAT_PDF));
    word.stateReason =
        readableReasons(keywordsOf(answer.get(), "printer-state-reasons").join(QLatin1Char(',')));
    word.answers = true;
    return word;
}

// Host and port of a device that does not speak IPP. Also found behind a backend that retries
// ("beh:/1/0/5/socket://…").
struct Address {
    QByteArray host;
    int port = 0;
};

std::optional<Address> addressOf(const QString& uri) {
    static const QRegularExpression pattern(
        QStringLiteral("(socket|lpd|http|https)://([^/:\\[\\]]+|\\[[^\\]]+\\])(?::(\\d+))?"));
    const QRegularExpressionMatch match = pattern.match(uri);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    const QString scheme = match.captured(1);
    const int usual = scheme == QLatin1String("socket") ? 9100
                      : scheme == QLatin1String("lpd")  ? 515
                      : scheme == QLatin1String("http") ? 80
                                                        : 443;
    const int port = match.captured(3).toInt();
    return Address{match.captured(2).remove(u'[').remove(u']').toUtf8(), port > 0 ? port : usual};
}

// Returns whether the address accepts a connection. Sends nothing.
bool acceptsConnection(const Address& address) {
    return Connection(httpConnect2(address.host.constData(), address.port, nullptr, AF_UNSPEC,
                                   HTTP_ENCRYPTION_NEVER, 1, connectionTimeout, nullptr)) !=
           nullptr;
}

void markLoaded(std::vector<PrinterMedia>& media, const std::vector<QSizeF>& loaded) {
    constexpr double largestDifference = 0.6; // mm
    for (PrinterMedia& one : media) {
        one.ready = loaded.empty() || std::any_of(loaded.begin(), loaded.end(), [&](QSizeF size) {
                        return std::abs(size.width() - one.size.width()) < largestDifference &&
                               std::abs(size.height() - one.size.height()) < largestDifference;
                    });
    }
}

// Monochrome printers are known by print-color-mode, or on older queues by their type.
bool printsColour(const Dest& dest, cups_dinfo_t* info) {
    if (cupsCheckDestSupported(CUPS_HTTP_DEFAULT, dest.get(), info, CUPS_PRINT_COLOR_MODE,
                               nullptr)) {
        return cupsCheckDestSupported(CUPS_HTTP_DEFAULT, dest.get(), info, CUPS_PRINT_COLOR_MODE,
                                      CUPS_PRINT_COLOR_MODE_COLOR) != 0;
    }
    return (option(dest, "printer-type").toUInt() & CUPS_PRINTER_COLOR) != 0;
}

JobStatus statusOf(ipp_t* answer) {
    const auto text = [&](const char* name, ipp_tag_t tag) {
        ipp_attribute_t* attribute = ippFindAttribute(answer, name, tag);
        return attribute ? QString::fromUtf8(ippGetString(attribute, 0, nullptr)) : QString();
    };
    ipp_attribute_t* state = ippFindAttribute(answer, "job-state", IPP_TAG_ENUM);
    const QString message = text("job-printer-state-message", IPP_TAG_TEXT);
    const QString reason =
        message.isEmpty() ? readableReasons(text("job-state-reasons", IPP_TAG_KEYWORD)) : message;
    switch (state ? ippGetInteger(state, 0) : 0) {
    case IPP_JSTATE_HELD:
        return {JobState::Held, reason};
    case IPP_JSTATE_PROCESSING:
        return {JobState::Printing, reason};
    case IPP_JSTATE_STOPPED:
        return {JobState::Stopped, reason};
    case IPP_JSTATE_CANCELED:
        return {JobState::Cancelled, reason};
    case IPP_JSTATE_ABORTED:
        return {JobState::Failed, reason};
    case IPP_JSTATE_COMPLETED:
        return {JobState::Printed, reason};
    default:
        return {JobState::Waiting, reason};
    }
}

class CupsPrintSystem : public PrintSystem {
public:
    QStringList printers() override {
        cups_dest_t* dests = nullptr;
        const int count = cupsGetDests2(CUPS_HTTP_DEFAULT, &dests);
        QStringList names;
        for (int i = 0; i < count; ++i) {
            if (!dests[i].instance) {
                names << QString::fromUtf8(dests[i].name);
            }
        }
        cupsFreeDests(count, dests);
        names.sort();
        return names;
    }

    std::optional<PrinterInfo> printer(const QString& name) override {
        const Dest dest = namedDest(name);
        if (!dest) {
            return std::nullopt;
        }
        PrinterInfo info;
        info.name = name;
        info.description = option(dest, "printer-info");
        info.isDefault = dest->is_default != 0;
        info.state = stateOf(option(dest, "printer-state"));
        info.stateReason = readableReasons(option(dest, "printer-state-reasons"));
        info.acceptsJobs = option(dest, "printer-is-accepting-jobs") != QLatin1String("false");
        const DestInfo details(cupsCopyDestInfo(CUPS_HTTP_DEFAULT, dest.get()));
        if (!details) {
            throw Error(
                Text::tr("The printer does not report its capabilities: %1").arg(lastMessage()),
                name);
        }
        info.printsColour = printsColour(dest, details.get());
        addMedia(info.media, dest.get(), details.get(), CUPS_MEDIA_FLAGS_BORDERLESS);
        addMedia(info.media, dest.get(), details.get(), CUPS_MEDIA_FLAGS_DEFAULT);
        info.customMedia = customMediaOf(info, dest.get(), details.get());
        const QString uri = option(dest, "device-uri");
        info.reportsPrinted = speaksIpp(uri);
        const DeviceReport word = info.reportsPrinted ? wordOfDevice(dest.get()) : DeviceReport{};
        markLoaded(info.media, word.loaded);
        if (info.customMedia) {
            info.customMedia->loaded = word.loaded;
        }
        info.scaling = word.scaling;
        info.canForbidScaling = word.canForbidScaling;
        if (info.stateReason.isEmpty()) {
            info.stateReason = word.stateReason;
        }
        info.answers = info.reportsPrinted ? word.answers : hasAnswered(uri);
        return info;
    }

    PrintJob submit(const PrintTask& task) override {
        const Dest dest = namedDest(task.printer);
        if (dest && task.pastQueue) {
            return submitToDevice(dest.get(), task);
        }
        const DestInfo info(dest ? cupsCopyDestInfo(CUPS_HTTP_DEFAULT, dest.get()) : nullptr);
        Options options;
        options.add("media-col", collection(task.media));
        for (const auto& [name, value] : trueSizeOptions) {
            options.add(name, value);
        }
        if (info && printsColour(dest, info.get())) {
            options.add(CUPS_PRINT_COLOR_MODE, CUPS_PRINT_COLOR_MODE_COLOR);
        }
        int id = 0;
        const QByteArray title = task.title.toUtf8();
        if (!info ||
            cupsCreateDestJob(CUPS_HTTP_DEFAULT, dest.get(), info.get(), &id, title.constData(),
                              options.count(), options.data()) > IPP_STATUS_OK_CONFLICTING) {
            throw Error(Text::tr("The printer refuses the job: %1").arg(lastMessage()),
                        task.printer);
        }
        const PrintJob job{task.printer, id};
        const bool sent =
            cupsStartDestDocument(CUPS_HTTP_DEFAULT, dest.get(), info.get(), id, title.constData(),
                                  CUPS_FORMAT_PDF, 0, nullptr, 1) == HTTP_STATUS_CONTINUE &&
            cupsWriteRequestData(CUPS_HTTP_DEFAULT, task.pdf.constData(),
                                 std::size_t(task.pdf.size())) == HTTP_STATUS_CONTINUE;
        if (cupsFinishDestDocument(CUPS_HTTP_DEFAULT, dest.get(), info.get()) >
                IPP_STATUS_OK_CONFLICTING ||
            !sent) {
            const QString message = lastMessage();
            cancel(job);
            throw Error(Text::tr("The sheet could not be sent to the printer: %1").arg(message),
                        task.printer);
        }
        return job;
    }

    JobStatus status(const PrintJob& job) override {
        const char* const wanted[] = {"job-state", "job-state-reasons",
                                      "job-printer-state-message"};
        const Message answer = ask(job, IPP_OP_GET_JOB_ATTRIBUTES, [&](ipp_t* request) {
            ippAddStrings(request, IPP_TAG_OPERATION, IPP_TAG_KEYWORD, "requested-attributes",
                          int(std::size(wanted)), nullptr, wanted);
        });
        if (!answer || ippGetStatusCode(answer.get()) > IPP_STATUS_OK_CONFLICTING) {
            throw Error(Text::tr("The print system does not report the state of the job: %1")
                            .arg(lastMessage()),
                        job.printer);
        }
        return statusOf(answer.get());
    }

    void cancel(const PrintJob& job) override { ask(job, IPP_OP_CANCEL_JOB); }

private:
    // Returns whether a device that cannot be queried accepts connections, or cannot be tested.
    // After one success the device is not tested again, because some devices accept one connection
    // at a time, and the job needs it.
    bool hasAnswered(const QString& uri) {
        const std::optional<Address> address = addressOf(uri);
        if (address && !reached_.contains(uri) && acceptsConnection(*address)) {
            reached_.insert(uri);
        }
        return !address || reached_.contains(uri);
    }

    // Sends the job directly to the printer, with options that the printer's queue would not pass
    // on. The printer must report options that it does not know (RFC 8011, 4.1.7); the job is then
    // cancelled.
    static PrintJob submitToDevice(cups_dest_t* dest, const PrintTask& task) {
        const Device device = deviceOf(dest);
        const auto refused = [&](const QString& reason) {
            return Error(Text::tr("The printer refuses the job: %1").arg(reason), task.printer);
        };
        if (!device.connection) {
            throw refused(lastMessage());
        }
        ipp_t* request = deviceRequest(IPP_OP_PRINT_JOB, device);
        ippAddString(request, IPP_TAG_OPERATION, IPP_TAG_NAME, "job-name", nullptr,
                     task.title.toUtf8().constData());
        ippAddString(request, IPP_TAG_OPERATION, IPP_TAG_MIMETYPE, "document-format", nullptr,
                     CUPS_FORMAT_PDF);
        Options options;
        options.add("media-col", collection(task.media));
        for (const char* const name : {"print-scaling", "sides", "copies"}) {
            options.add(name, trueSizeOption(name));
        }
        cupsEncodeOptions2(request, options.count(), options.data(), IPP_TAG_JOB);
        const Message asked(request);
        const char* const resource = device.resource.constData();
        http_t* const http = device.connection.get();
        const bool sent =
            cupsSendRequest(http, request, resource,
                            ippLength(request) + std::size_t(task.pdf.size())) ==
                HTTP_STATUS_CONTINUE &&
            cupsWriteRequestData(http, task.pdf.constData(), std::size_t(task.pdf.size())) ==
                HTTP_STATUS_CONTINUE;
        const Message answer(cupsGetResponse(http, resource));
        ipp_attribute_t* id =
            answer ? ippFindAttribute(answer.get(), "job-id", IPP_TAG_INTEGER) : nullptr;
        if (!sent || !id || ippGetStatusCode(answer.get()) > IPP_STATUS_OK_CONFLICTING) {
            throw refused(lastMessage());
        }
        const PrintJob job{task.printer, ippGetInteger(id, 0), true};
        ipp_attribute_t* scaling = ippFindAttribute(answer.get(), "print-scaling", IPP_TAG_ZERO);
        if (scaling && ippGetGroupTag(scaling) == IPP_TAG_UNSUPPORTED_GROUP) {
            ask(job, IPP_OP_CANCEL_JOB);
            throw refused(Text::tr("the printer would change the page size"));
        }
        return job;
    }

    // Queries a job at its queue or, for direct jobs, at the printer. Returns null if there is no
    // answer.
    static Message ask(const PrintJob& job, ipp_op_t operation,
                       const std::function<void(ipp_t*)>& add = {}) {
        const auto added = [&](ipp_t* request) {
            if (add) {
                add(request);
            }
            return request;
        };
        if (!job.pastQueue) {
            return Message(
                cupsDoRequest(CUPS_HTTP_DEFAULT, added(queueRequest(operation, job)), "/"));
        }
        const Dest dest = namedDest(job.printer);
        const Device device = dest ? deviceOf(dest.get()) : Device{};
        if (!device.connection) {
            return {};
        }
        ipp_t* request = deviceRequest(operation, device);
        ippAddInteger(request, IPP_TAG_OPERATION, IPP_TAG_INTEGER, "job-id", job.id);
        return Message(
            cupsDoRequest(device.connection.get(), added(request), device.resource.constData()));
    }

    // Returns a request, which cupsDoRequest frees.
    static ipp_t* queueRequest(ipp_op_t operation, const PrintJob& job) {
        ipp_t* request = ippNewRequest(operation);
        const QByteArray uri = QByteArray("ipp://localhost/jobs/") + QByteArray::number(job.id);
        ippAddString(request, IPP_TAG_OPERATION, IPP_TAG_URI, "job-uri", nullptr, uri.constData());
        ippAddString(request, IPP_TAG_OPERATION, IPP_TAG_NAME, "requesting-user-name", nullptr,
                     cupsUser());
        return request;
    }

    QSet<QString> reached_; // devices that have accepted a connection
};

} // namespace

std::unique_ptr<PrintSystem> cupsPrintSystem() {
    return std::make_unique<CupsPrintSystem>();
}

} // namespace dipwright
