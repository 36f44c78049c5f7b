#include "serving/ServerClient.h"

#include "base/Error.h"
#include "base/JsonText.h"
#include "base/OneLine.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>
#include <QThread>
#include <QUrl>
#include <httplib.h>
#include <sys/socket.h>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Serving)
};

constexpr int secondsWithoutAnswer = 10; // closing the window waits for it
constexpr std::size_t mostAnswerBytes = 8 << 20;
constexpr unsigned long pollMilliseconds = 250;
constexpr qint64 longestSilence = 60'000; // ms
constexpr qint64 piece = 1 << 18;
constexpr qint64 megabyte = 1'000'000;

std::string jobPath(const QString& id) {
    return "/v1/jobs/" + QUrl::toPercentEncoding(id).toStdString();
}

} // namespace

struct ServerClient::Data {
    Data(const ServerAddress& where, const QByteArray& token)
        : address(where), client(address.isSocket() ? QFile::encodeName(where.socket).toStdString()
                                                    : where.host.toStdString(),
                                 address.isSocket() ? 1 : where.port) {
        if (address.isSocket()) {
            client.set_address_family(AF_UNIX);
        }
        client.set_connection_timeout(secondsWithoutAnswer);
        client.set_read_timeout(secondsWithoutAnswer);
        client.set_write_timeout(secondsWithoutAnswer);
        client.set_default_headers(
            {{"Authorization", "Bearer " + token.toStdString()}, {"Host", "localhost"}});
    }

    [[noreturn]] void failUnreached(httplib::Error error) const {
        throw Error(Text::tr("The server does not answer (%1). Check that it runs, and the address")
                        .arg(QString::fromStdString(httplib::to_string(error))),
                    address.text());
    }

    // Returns the answer's JSON. Throws Error with the server's sentence.
    QJsonObject json(const httplib::Result& result) const {
        if (!result) {
            failUnreached(result.error());
        }
        const QByteArray body = QByteArray::fromStdString(result->body);
        if (std::size_t(body.size()) > mostAnswerBytes) {
            throw Error(Text::tr("The server's answer is too long"), address.text());
        }
        requireJsonWithinLimits(body, address.text());
        const QJsonObject object = QJsonDocument::fromJson(body).object();
        if (result->status / 100 != 2) {
            const QString sentence = oneLine(object[QStringLiteral("error")].toString());
            throw Error(sentence.isEmpty()
                            ? Text::tr("The server refused the request (%1)").arg(result->status)
                            : Text::tr("The server says: %1").arg(sentence),
                        address.text());
        }
        return object;
    }

    // Returns the job, even if the server does not answer for a while.
    QJsonObject poll(const QString& id, const CancelToken& cancelToken) {
        QElapsedTimer silence;
        silence.start();
        while (true) {
            const httplib::Result result = client.Get(jobPath(id));
            if (result || silence.elapsed() > longestSilence) {
                return json(result);
            }
            cancelToken.throwIfCancelled();
            QThread::msleep(pollMilliseconds);
        }
    }

    // Throws Error if the server will refuse a project of this size. A server that refuses an
    // upload ends the connection, and its reason may be lost.
    void requireRoom(qint64 bytes) {
        const QJsonObject status = json(client.Get("/v1/status"));
        const QJsonObject limits = status[QStringLiteral("limits")].toObject();
        const qint64 most = qint64(limits[QStringLiteral("bytes")].toDouble());
        if (bytes > most) {
            throw Error(Text::tr("The project has %1 MB, and the server allows %2 MB")
                            .arg(bytes / megabyte)
                            .arg(most / megabyte),
                        address.text());
        }
        int jobs = 0;
        for (const QJsonValue& count : status[QStringLiteral("jobs")].toObject()) {
            jobs += count.toInt();
        }
        if (jobs >= limits[QStringLiteral("jobs")].toInt()) {
            throw Error(Text::tr("The server has too many jobs; remove finished ones"),
                        address.text());
        }
    }

    ServerAddress address;
    httplib::Client client;
};

ServerClient::ServerClient(const ServerAddress& address, const QByteArray& token)
    : data_(std::make_unique<Data>(address, token)) {}

ServerClient::~ServerClient() = default;

QJsonObject ServerClient::status() {
    return data_->json(data_->client.Get("/v1/status"));
}

QString ServerClient::submit(const QString& project, const QString& name,
                             const CancelToken& cancelToken) {
    QFile file(project);
    if (!file.open(QIODevice::ReadOnly)) {
        throw Error(Text::tr("The project cannot be read: %1").arg(file.errorString()), project);
    }
    data_->requireRoom(file.size());
    const auto provider = [&](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
        file.seek(qint64(offset));
        const QByteArray bytes = file.read(std::min(qint64(length), piece));
        return !cancelToken.isCancelled() && !bytes.isEmpty() &&
               sink.write(bytes.constData(), std::size_t(bytes.size()));
    };
    const httplib::Result result =
        data_->client.Post("/v1/jobs?name=" + QUrl::toPercentEncoding(name).toStdString(),
                           std::size_t(file.size()), provider, "application/zip");
    if (!result) {
        cancelToken.throwIfCancelled(); // the reason why nothing was answered
    }
    const QString id = data_->json(result)[QStringLiteral("id")].toString();
    if (cancelToken.isCancelled()) {
        abandon(id);
        throw Cancelled();
    }
    return id;
}

QJsonObject ServerClient::job(const QString& id) {
    return data_->json(data_->client.Get(jobPath(id)));
}

void ServerClient::cancel(const QString& id) {
    data_->json(data_->client.Post(jobPath(id) + "/cancel", std::string(), "application/json"));
}

void ServerClient::remove(const QString& id) {
    data_->json(data_->client.Delete(jobPath(id)));
}

void ServerClient::fetch(const QString& id, const QString& name, const QString& path,
                         qint64 mostBytes, const CancelToken& cancelToken) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        throw Error(Text::tr("The file cannot be written: %1").arg(file.errorString()), path);
    }
    qint64 received = 0;
    int status = 0;
    const httplib::Result result = data_->client.Get(
        jobPath(id) + "/files/" + QUrl::toPercentEncoding(name, "/").toStdString(),
        [&](const httplib::Response& response) {
            status = response.status;
            return status == 200;
        },
        [&](const char* bytes, std::size_t count) {
            received += qint64(count);
            return !cancelToken.isCancelled() && received <= mostBytes &&
                   file.write(bytes, qint64(count)) == qint64(count);
        });
    cancelToken.throwIfCancelled();
    if (status != 0 && status != 200) {
        throw Error(Text::tr("The server has no file %1").arg(name), data_->address.text());
    }
    if (received > mostBytes) {
        throw Error(Text::tr("The server's file %1 is too large").arg(name), data_->address.text());
    }
    if (!result) {
        data_->failUnreached(result.error());
    }
}

void ServerClient::abandon(const QString& id) {
    for (const auto& step : {&ServerClient::cancel, &ServerClient::remove}) {
        try {
            (this->*step)(id);
        } catch (const Error&) { // it has ended, or the server cannot be reached
        }
    }
}

QJsonObject ServerClient::wait(const QString& id, const Progress& progress) {
    try {
        while (true) {
            const QJsonObject state = data_->poll(id, progress.cancelToken);
            const QString word = state[QStringLiteral("state")].toString();
            const QString text = oneLine(state[QStringLiteral("text")].toString());
            if (word == u"done") {
                return state;
            }
            if (word == u"failed" || word == u"cancelled") {
                throw Error(Text::tr("The server could not run the job: %1").arg(text),
                            data_->address.text());
            }
            progress(state[QStringLiteral("progress")].toDouble(),
                     word == u"queued" ? Text::tr("Waiting for the server")
                                       : Text::tr("On the server: %1").arg(text));
            QThread::msleep(pollMilliseconds);
        }
    } catch (const Cancelled&) {
        try {
            cancel(id);
        } catch (const Error&) { // it has ended, or the server cannot be reached
        }
        throw;
    }
}

} // namespace dipwright
