#include "serving/JobServer.h"

#include "base/Error.h"
#include "base/ProgramName.h"
#include "disk/SmallFile.h"
#include "serving/SocketFile.h"

#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <atomic>
#include <httplib.h>
#include <regex>
#include <thread>

namespace dipwright {
namespace {

using httplib::ContentReader;
using httplib::Request;
using httplib::Response;

// Limits on connections. One request per connection, so that the rest of a refused one is dropped.
constexpr int threads = 8;
constexpr int secondsWithoutByte = 20;
constexpr qint64 longestUpload = 600'000; // ms
constexpr qint64 longestToken = 4096;
constexpr int tokenBytes = 32;

enum Status {
    Ok = 200,
    Created = 201,
    BadRequest = 400,
    Unauthorized = 401,
    NotFound = 404,
    NotAllowed = 405,
    Conflict = 409,
    LengthRequired = 411,
    TooLarge = 413,
    Unprocessable = 422,
    TooMany = 429,
    Failed = 500
};

const char* const statusPath = "/v1/status";
const char* const jobsPath = "/v1/jobs";
const char* const jobPath = "/v1/jobs/([^/]+)";
const char* const cancelPath = "/v1/jobs/([^/]+)/cancel";
const char* const filePath = "/v1/jobs/([^/]+)/files/(.+)";

// Returns the methods of an address as in the header Allow; empty if there is nothing.
std::string methodsOf(const std::string& address) {
    static const std::vector<std::pair<std::regex, std::string>> all{
        {std::regex(statusPath), "GET, HEAD"},
        {std::regex(jobsPath), "GET, HEAD, POST"},
        {std::regex(jobPath), "DELETE, GET, HEAD"},
        {std::regex(cancelPath), "POST"},
        {std::regex(filePath), "GET, HEAD"}};
    const auto found = std::ranges::find_if(
        all, [&](const auto& one) { return std::regex_match(address, one.first); });
    return found == all.end() ? std::string() : found->second;
}

void answer(Response& response, int status, const QJsonObject& json) {
    response.status = status;
    response.set_content(QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString(),
                         "application/json");
}

void refuse(Response& response, int status, const QString& sentence) {
    answer(response, status, {{"error", sentence}});
}

// Takes the same time for every token of the same length.
bool isSame(const std::string& given, const QByteArray& token) {
    unsigned difference = unsigned(given.size() ^ std::size_t(token.size()));
    for (std::size_t i = 0; i < given.size() && i < std::size_t(token.size()); ++i) {
        difference |= unsigned(given[i] ^ token[qsizetype(i)]);
    }
    return difference == 0;
}

// Returns the token of an Authorization header; empty if it has another scheme (RFC 9110, 11.1).
std::string bearerToken(const std::string& authorization) {
    constexpr std::size_t length = 7;
    const QByteArray scheme = QByteArray::fromStdString(authorization.substr(0, length));
    return scheme.compare("Bearer ", Qt::CaseInsensitive) == 0 ? authorization.substr(length)
                                                               : std::string();
}

QJsonObject jsonOf(const ServedJob& job) {
    return {{"id", job.id},
            {"name", job.name},
            {"state", nameOf(job.state)},
            {"submitted", job.submitted.toString(Qt::ISODateWithMs)},
            {"progress", job.progress},
            {"text", job.text},
            {"outcome", job.outcome}};
}

// Without SO_REUSEPORT, which would let a second server share the port.
void setSocketOptions(socket_t socket) {
#ifdef Q_OS_UNIX
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
#else
    httplib::default_socket_options(socket);
#endif
}

// An upload that is removed unless it is taken.
class Upload {
public:
    explicit Upload(JobSpool& spool) : spool_(spool), path_(spool.newUpload()) {}
    ~Upload() {
        if (path_) {
            spool_.dropUpload(*path_);
        }
    }
    Upload(const Upload&) = delete;
    Upload& operator=(const Upload&) = delete;

    bool isPossible() const { return path_.has_value(); }
    const QString& path() const { return *path_; }
    ServedJob take(const QString& name) {
        ServedJob job = spool_.add(*path_, name);
        path_.reset();
        return job;
    }

private:
    JobSpool& spool_;
    std::optional<QString> path_;
};

} // namespace

struct JobServer::Data {
    Data(const ServerAddress& where, const QByteArray& secret, JobSpool& jobs, CheckUpload uploads)
        : address(where), token(secret), spool(jobs), check(std::move(uploads)) {
        configure();
        server.Get(statusPath, [this](const Request&, Response& response) { status(response); });
        server.Get(jobsPath, [this](const Request&, Response& response) { list(response); });
        server.Post(jobsPath,
                    [this](const Request& request, Response& response,
                           const ContentReader& content) { submit(request, response, content); });
        server.Get(jobPath,
                   [this](const Request& request, Response& response) { show(request, response); });
        // Without reading a body: httplib waits for one even if the request has no length.
        server.Post(cancelPath, [this](const Request& request, Response& response,
                                       const ContentReader&) { cancel(request, response); });
        server.Delete(jobPath, [this](const Request& request, Response& response) {
            remove(request, response);
        });
        server.Get(filePath, [this](const Request& request, Response& response) {
            fetch(request, response);
        });
        const auto nothing = [](const Request&, Response& response, const ContentReader&) {
            response.status = NotFound;
        };
        server.Post(".*", nothing).Put(".*", nothing).Patch(".*", nothing);
    }

    void configure() {
        server.new_task_queue = [] { return new httplib::ThreadPool(threads); };
        server.set_socket_options(setSocketOptions);
        server.set_keep_alive_max_count(1);
        server.set_read_timeout(secondsWithoutByte);
        server.set_write_timeout(secondsWithoutByte);
        server.set_payload_max_length(std::size_t(spool.limits().mostBytes));
        // Before any content is read, and for every path.
        server.set_pre_routing_handler([this](const Request& request, Response& response) {
            if (isSame(bearerToken(request.get_header_value("Authorization")), token)) {
                return httplib::Server::HandlerResponse::Unhandled;
            }
            refuse(
                response, Unauthorized,
                QStringLiteral("The token is missing or wrong; send Authorization: Bearer TOKEN"));
            return httplib::Server::HandlerResponse::Handled;
        });
        server.set_error_handler([](const Request& request, Response& response) {
            const std::string methods = methodsOf(request.path);
            if (response.body.empty() && response.status == NotFound && !methods.empty()) {
                response.set_header("Allow", methods);
                refuse(response, NotAllowed,
                       QStringLiteral("This address does not accept the method; use %1")
                           .arg(QString::fromStdString(methods)));
            } else if (response.body.empty()) {
                refuse(response, response.status,
                       response.status == NotFound
                           ? QStringLiteral("There is nothing at this address")
                           : QStringLiteral("The request cannot be served"));
            }
        });
        server.set_exception_handler(
            [](const Request&, Response& response, const std::exception_ptr& failure) {
                try {
                    std::rethrow_exception(failure);
                } catch (const Error& error) {
                    refuse(response, Failed, error.sentence());
                } catch (...) {
                    refuse(response, Failed, QStringLiteral("The request failed"));
                }
            });
    }

    void listen() {
        bool isBound = false;
        if (address.isSocket()) {
            clearSocket(address.socket);
            server.set_address_family(AF_UNIX);
            const OwnerOnly own; // from the beginning
            isBound = server.bind_to_port(QFile::encodeName(address.socket).toStdString(), 1) &&
                      QFile::setPermissions(address.socket, QFile::ReadOwner | QFile::WriteOwner);
        } else {
            isBound = server.bind_to_port(address.host.toStdString(), address.port);
        }
        if (!isBound) {
            throw Error(QStringLiteral("The address cannot be used: another program uses it, or "
                                       "you may not; choose another one"),
                        address.text());
        }
        thread = std::thread([this] { server.listen_after_bind(); });
        while (!server.is_running()) {
            std::this_thread::yield();
        }
    }

    void status(Response& response) const {
        const std::vector<ServedJob> jobs = spool.jobs();
        QJsonObject counts;
        for (const ServedJob& job : jobs) {
            counts[nameOf(job.state)] = counts[nameOf(job.state)].toInt() + 1;
        }
        const SpoolLimits& limits = spool.limits();
        answer(response, Ok,
               {{"program", QStringLiteral("Dipwright ") + programVersion()},
                {"jobs", counts},
                {"limits", QJsonObject{{"bytes", limits.mostBytes},
                                       {"jobs", limits.mostJobs},
                                       {"seconds", limits.mostSeconds}}}});
    }

    void list(Response& response) const {
        QJsonArray jobs;
        for (const ServedJob& job : spool.jobs()) {
            jobs.append(jsonOf(job));
        }
        answer(response, Ok, {{"jobs", jobs}});
    }

    void submit(const Request& request, Response& response, const ContentReader& content) {
        if (!request.has_header("Content-Length") && !request.has_header("Transfer-Encoding")) {
            refuse(response, LengthRequired,
                   QStringLiteral("The request has no project; send it as the request's body"));
            return;
        }
        bool isNumber = true;
        const quint64 announced =
            request.has_header("Content-Length")
                ? QByteArray::fromStdString(request.get_header_value("Content-Length"))
                      .toULongLong(&isNumber)
                : 0;
        if (!isNumber || request.get_header_value_count("Content-Length") > 1) {
            refuse(response, BadRequest,
                   QStringLiteral("The request must have one header Content-Length, with a number "
                                  "of bytes"));
            return;
        }
        const qint64 most = spool.limits().mostBytes;
        const QString tooLarge =
            QStringLiteral("The project is larger than the server allows: %1 bytes").arg(most);
        if (announced > quint64(most)) {
            refuse(response, TooLarge, tooLarge);
            return;
        }
        Upload upload(spool);
        if (!upload.isPossible()) {
            refuse(response, TooMany,
                   QStringLiteral("The server has too many jobs, or no room on its disk. Remove "
                                  "finished jobs, or try again later"));
            return;
        }
        QFile file(upload.path());
        QElapsedTimer time;
        time.start();
        qint64 received = 0;
        const bool isOpen = file.open(QIODevice::WriteOnly | QIODevice::NewOnly);
        const bool isWhole = isOpen && content([&](const char* bytes, std::size_t count) {
                                 received += qint64(count);
                                 return !ending && received <= most &&
                                        time.elapsed() < longestUpload &&
                                        file.write(bytes, qint64(count)) == qint64(count);
                             });
        file.close();
        if (received > most) {
            refuse(response, TooLarge, tooLarge);
        } else if (!isWhole || file.error() != QFileDevice::NoError) {
            refuse(response, BadRequest, QStringLiteral("The project did not arrive as a whole"));
        } else {
            accept(request, response, upload);
        }
    }

    void accept(const Request& request, Response& response, Upload& upload) {
        try {
            check(upload.path());
        } catch (const Error& error) {
            refuse(response, Unprocessable,
                   QStringLiteral("This is no project: %1").arg(error.message()));
            return;
        }
        const ServedJob job = upload.take(QString::fromStdString(request.get_param_value("name")));
        response.set_header("Location", "/v1/jobs/" + job.id.toStdString());
        answer(response, Created, jsonOf(job));
    }

    static QString idOf(const Request& request) {
        return QString::fromStdString(request.matches[1].str());
    }

    static void refuseUnknown(Response& response) {
        refuse(response, NotFound, QStringLiteral("There is no job of this id"));
    }

    void show(const Request& request, Response& response) const {
        const std::optional<ServedJob> job = spool.job(idOf(request));
        if (!job) {
            refuseUnknown(response);
            return;
        }
        QJsonObject json = jsonOf(*job);
        QJsonArray files;
        for (const QString& name : spool.files(job->id)) {
            files.append(QJsonObject{{"name", name},
                                     {"bytes", QFileInfo(spool.file(job->id, name)).size()}});
        }
        json["files"] = files;
        answer(response, Ok, json);
    }

    void cancel(const Request& request, Response& response) {
        const QString id = idOf(request);
        if (!spool.job(id)) {
            refuseUnknown(response);
        } else if (!spool.cancel(id)) {
            refuse(response, Conflict, QStringLiteral("The job has ended already"));
        } else {
            const std::optional<ServedJob> job = spool.job(id); // others may have removed it
            answer(response, Ok, job ? jsonOf(*job) : QJsonObject());
        }
    }

    void remove(const Request& request, Response& response) {
        if (spool.remove(idOf(request))) {
            answer(response, Ok, {});
        } else {
            refuseUnknown(response);
        }
    }

    void fetch(const Request& request, Response& response) const {
        const QString name = QString::fromStdString(request.matches[2].str());
        const auto file = std::make_shared<QFile>(spool.file(idOf(request), name));
        if (file->fileName().isEmpty() || !file->open(QIODevice::ReadOnly)) {
            refuse(response, NotFound, QStringLiteral("The job has no file of this name"));
            return;
        }
        response.set_content_provider(
            std::size_t(file->size()), "application/octet-stream",
            [this, file](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                constexpr std::size_t piece = 1 << 20;
                file->seek(qint64(offset));
                const QByteArray bytes = file->read(qint64(std::min(length, piece)));
                return !ending && !bytes.isEmpty() &&
                       sink.write(bytes.constData(), std::size_t(bytes.size()));
            });
    }

    ServerAddress address;
    QByteArray token;
    JobSpool& spool;
    CheckUpload check;
    httplib::Server server;
    std::thread thread;
    std::atomic<bool> ending = false; // transfers stop
};

JobServer::JobServer(const ServerAddress& address, const QByteArray& token, JobSpool& spool,
                     CheckUpload check)
    : data_(std::make_unique<Data>(address, token, spool, std::move(check))) {
    data_->listen();
}

JobServer::~JobServer() {
    data_->ending = true;
    data_->server.stop();
    data_->thread.join();
    if (data_->address.isSocket()) {
        QFile::remove(data_->address.socket);
    }
}

QByteArray newToken() {
    std::array<quint32, tokenBytes / sizeof(quint32)> words{};
    QRandomGenerator::system()->fillRange(words.data(), qsizetype(words.size()));
    return QByteArray(reinterpret_cast<const char*>(words.data()), tokenBytes)
        .toBase64(QByteArray::Base64UrlEncoding | QByteArray::OmitTrailingEquals);
}

QByteArray tokenIn(const QString& path) {
    static const QRegularExpression pattern(QStringLiteral("^[A-Za-z0-9_.~+/=-]{16,}$"));
    if (!QFileInfo::exists(path)) {
        const OwnerOnly own;
        QFile file(path);
        const bool isWritten = file.open(QIODevice::WriteOnly | QIODevice::NewOnly) &&
                               file.write(newToken() + '\n') > 0 && file.flush();
        if (!isWritten) {
            throw Error(QStringLiteral("The token cannot be saved: %1").arg(file.errorString()),
                        path);
        }
    }
    const auto others = QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
    if (QFile::permissions(path) & others) {
        throw Error(QStringLiteral("Other users may read the token; run chmod 600 on the file"),
                    path);
    }
    const QByteArray token = readSmallFile(path, longestToken).trimmed();
    if (!pattern.match(QString::fromLatin1(token)).hasMatch()) {
        throw Error(QStringLiteral("The file holds no token: at least 16 letters and digits in one "
                                   "line"),
                    path);
    }
    return token;
}

} // namespace dipwright
