// Tests the job server: what a client may do, and that a client with the wrong token, a job that is
// too large, or one that is cut off does nothing.
#include "TestFiles.h"
#include "TestFolders.h"
#include "base/Error.h"
#include "serving/JobServer.h"
#include "serving/ServerClient.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <atomic>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

using namespace dipwright;
using namespace dipwright::test;

namespace {

const QByteArray token = "0123456789abcdefghij";
const QByteArray project = "PROJECT " + QByteArray(500, 'x');

// Stands for a run of a project: writes two files, or does what the project's text says.
QJsonObject fakeRun(const QString& path, const QString& folder, const Progress& progress) {
    const QByteArray text = bytesOf(path);
    progress(0.5, QStringLiteral("half way"));
    if (text.contains("fail")) {
        throw Error(QStringLiteral("This job fails"), path);
    }
    while (text.contains("wait")) {
        progress(0.5, QStringLiteral("waiting"));
        QThread::msleep(5);
    }
    QDir().mkpath(folder + "/immersion-1");
    writeFile(folder + "/report.json", "{}");
    writeFile(folder + "/immersion-1/sheet.png", QByteArray(3'000'000, 's'));
    return {{"verdict", "print"}};
}

void checkProject(const QString& path) {
    if (!bytesOf(path).startsWith("PROJECT")) {
        throw Error(QStringLiteral("it does not begin like one"), path);
    }
}

// Sends bytes to a Unix socket. Returns the whole answer, or nothing if `cutOff`: the connection is
// then closed at once.
QByteArray talk(const QString& path, const QByteArray& bytes, bool cutOff = false) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const QByteArray name = path.toLocal8Bit();
    std::copy(name.begin(), name.end(), address.sun_path);
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    if (::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof(address)) != 0) {
        ::close(socket);
        return "no connection";
    }
    ::send(socket, bytes.constData(), std::size_t(bytes.size()), MSG_NOSIGNAL);
    QByteArray answer;
    char buffer[4096];
    while (!cutOff) {
        const auto count = ::recv(socket, buffer, sizeof(buffer), 0);
        if (count <= 0) {
            break;
        }
        answer.append(buffer, count);
    }
    ::close(socket);
    return answer;
}

QByteArray request(const QByteArray& line, const QByteArray& secret, const QByteArray& more = {}) {
    return line + " HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer " + secret + "\r\n" + more;
}

QByteArray post(qsizetype length, const QByteArray& body, const QByteArray& secret = token) {
    return request("POST /v1/jobs?name=ball.dipw", secret,
                   "Content-Length: " + QByteArray::number(length) + "\r\n\r\n" + body);
}

} // namespace

class ServeTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        limits_ = {};
        limits_.mostBytes = 100'000;
        writeFile(path("ball.dipw"), project);
        writeFile(path("wait.dipw"), project + "wait");
        writeFile(path("fail.dipw"), project + "fail");
    }
    void cleanup() { stop(); }

    void submit_project_runsAndGivesItsFiles() {
        start();
        ServerClient client = connected();
        const QString id = client.submit(path("ball.dipw"), "My ball.dipw", {});
        std::atomic<double> most = 0;
        const QJsonObject job =
            client.wait(id, {[&](double share, const QString&) { most = share; }, {}});
        QCOMPARE(job["name"].toString(), "My ball");
        QCOMPARE(job["outcome"].toObject()["verdict"].toString(), "print");
        QCOMPARE(job["files"].toArray().size(), 2);
        client.fetch(id, "immersion-1/sheet.png", path("sheet.png"), 4'000'000, {});
        QCOMPARE(bytesOf(path("sheet.png")), QByteArray(3'000'000, 's'));
        QVERIFY_EXCEPTION_THROWN(
            client.fetch(id, "immersion-1/sheet.png", path("sheet.png"), 1000, {}), Error);
        QCOMPARE(client.status()["jobs"].toObject()["done"].toInt(), 1);
        client.remove(id);
        QVERIFY(spool_->jobs().empty());
        QCOMPARE(filesBelow(path("jobs/results")), QStringList());
    }

    void wrongToken_anyRequest_doesNothing() {
        start();
        for (const QByteArray& wrong : {QByteArray("wrong"), QByteArray(), token + "x",
                                        token.chopped(1), QByteArray(token.size(), 'z')}) {
            QVERIFY(talk(socket_, post(project.size(), project, wrong)).contains(" 401 "));
        }
        QVERIFY(
            talk(socket_, "GET /v1/jobs HTTP/1.1\r\nHost: localhost\r\n\r\n").contains(" 401 "));
        QVERIFY(talk(socket_, request("GET /v1/nothing", "wrong", "\r\n")).contains(" 401 "));
        const QByteArray asked = request("GET /v1/nothing", token, "\r\n");
        QVERIFY(talk(socket_, asked).contains(" 404 "));
        QVERIFY(talk(socket_, QByteArray(asked).replace("Bearer", "bearer")).contains(" 404 "));
        QVERIFY(talk(socket_, QByteArray(asked).replace("Bearer", "Basic")).contains(" 401 "));
        requireNothing();
        ServerClient stranger(serverAddress(socket_), "wrong");
        QVERIFY_EXCEPTION_THROWN(stranger.submit(path("ball.dipw"), "ball", {}), Error);
        requireNothing();
    }

    void upload_tooLarge_doesNothing() {
        start();
        const QByteArray large(qsizetype(limits_.mostBytes) + 1, 'x');
        QVERIFY(talk(socket_, post(large.size(), {})).contains(" 413 "));
        requireNothing();
        // Without a length, the server counts.
        QByteArray chunked = request("POST /v1/jobs", token, "Transfer-Encoding: chunked\r\n\r\n");
        for (int i = 0; i < 3; ++i) {
            chunked += QByteArray::number(60'000, 16) + "\r\n" + QByteArray(60'000, 'x') + "\r\n";
        }
        QVERIFY(!talk(socket_, chunked + "0\r\n\r\n").contains(" 201 "));
        requireNothing();
    }

    void submit_tooLarge_isRefusedWithTheLimit() {
        limits_.mostBytes = 100;
        start();
        try {
            connected().submit(path("ball.dipw"), "ball", {});
            QFAIL("was taken");
        } catch (const Error& error) {
            QVERIFY(error.message().contains("allows"));
        }
        requireNothing();
    }

    void upload_cutOffInTheMiddle_doesNothing() {
        start();
        talk(socket_, post(project.size(), project.left(200)), true);
        talk(socket_, post(project.size(), {}).left(40), true);
        QTest::qWait(200);
        requireNothing();
        ServerClient client = connected(); // and others are served
        client.wait(client.submit(path("ball.dipw"), "ball", {}), {});
    }

    void upload_lengthIsNoNumberOrTwo_isRefused() {
        start();
        for (const char* length :
             {"-5", "12x", "99999999999999999999999", "2\r\nContent-Length: 3"}) {
            QVERIFY(talk(socket_, request("POST /v1/jobs", token,
                                          QByteArray("Content-Length: ") + length + "\r\n\r\n{}"))
                        .contains(" 400 "));
        }
        requireNothing();
    }

    void request_withoutBody_isAnsweredAtOnce() {
        start();
        const auto answered = [&](const QByteArray& line) {
            return talk(socket_, request(line, token, "\r\n"));
        };
        QVERIFY(answered("POST /v1/jobs?name=ball.dipw").contains(" 411 "));
        QVERIFY(answered("POST /v1/jobs/1/cancel").contains("no job of this id"));
        for (const char* line : {"PUT /v1/nothing", "PATCH /v1/nothing", "POST /v1/nothing"}) {
            QVERIFY(answered(line).contains("nothing at this address"));
        }
        requireNothing();
    }

    void upload_noProject_isRefused() {
        start();
        QVERIFY(talk(socket_, post(4, "text")).contains(" 422 "));
        requireNothing();
    }

    void upload_tooManyJobs_isRefused() {
        limits_.mostJobs = 1;
        start();
        ServerClient client = connected();
        client.wait(client.submit(path("ball.dipw"), "ball", {}), {});
        QVERIFY(talk(socket_, post(project.size(), project)).contains(" 429 "));
        QCOMPARE(int(spool_->jobs().size()), 1);
    }

    void cancel_runningAndQueuedJob_endsBoth() {
        start();
        ServerClient client = connected();
        const QString running = client.submit(path("wait.dipw"), "a", {});
        const QString queued = client.submit(path("ball.dipw"), "b", {});
        QTRY_COMPARE(client.job(running)["text"].toString(), "waiting");
        client.cancel(queued);
        client.cancel(running);
        QTRY_COMPARE(client.job(running)["state"].toString(), "cancelled");
        QCOMPARE(client.job(queued)["state"].toString(), "cancelled");
        QVERIFY_EXCEPTION_THROWN(client.cancel(running), Error);
        QVERIFY_EXCEPTION_THROWN(client.job("20260101T000000000-0"), Error);
    }

    void wait_cancelledByUser_cancelsOnTheServer() {
        start();
        ServerClient client = connected();
        const QString id = client.submit(path("wait.dipw"), "a", {});
        Progress progress;
        progress.report = [&](double, const QString&) { progress.cancelToken.cancel(); };
        QVERIFY_EXCEPTION_THROWN(client.wait(id, progress), Cancelled);
        QTRY_COMPARE(spool_->job(id)->state, ServedState::Cancelled);
    }

    void submit_cancelledBeforeOrAfterSending_leavesNoJob() {
        start();
        CancelToken cancelToken;
        server_.reset();
        server_ = std::make_unique<JobServer>(serverAddress(socket_), token, *spool_,
                                              [&](const QString&) { cancelToken.cancel(); });
        for (int i = 0; i < 2; ++i) { // the second time, nothing is sent
            QVERIFY_EXCEPTION_THROWN(connected().submit(path("wait.dipw"), "a", cancelToken),
                                     Cancelled);
            requireNothing();
        }
    }

    void submit_tooManyJobs_saysWhatToDo() {
        limits_.mostJobs = 1;
        start();
        ServerClient client = connected();
        client.wait(client.submit(path("ball.dipw"), "ball", {}), {});
        try {
            client.submit(path("ball.dipw"), "ball", {});
            QFAIL("was taken");
        } catch (const Error& error) {
            QVERIFY(error.message().contains("remove finished"));
        }
    }

    void remove_runningJob_cancelsAndRemovesIt() {
        start();
        ServerClient client = connected();
        const QString running = client.submit(path("wait.dipw"), "a", {});
        const QString queued = client.submit(path("wait.dipw"), "b", {});
        QTRY_COMPARE(client.job(running)["text"].toString(), "waiting");
        client.remove(queued);
        client.remove(running);
        QTRY_VERIFY(spool_->jobs().empty());
        requireNothing();
        QCOMPARE(filesBelow(path("jobs/cancelled")), QStringList());
        client.wait(client.submit(path("ball.dipw"), "ball", {}), {}); // the next one runs
    }

    void run_projectCannotBeMoved_failsAndTheServerLives() {
        start();
        QVERIFY(QDir(path("jobs/running")).removeRecursively());
        ServerClient client = connected();
        const QString id = client.submit(path("ball.dipw"), "ball", {});
        QTRY_COMPARE(spool_->job(id)->state, ServedState::Failed);
        QVERIFY(spool_->job(id)->text.contains("cannot be moved"));
        QVERIFY(QDir().mkpath(path("jobs/running")));
        client.wait(client.submit(path("ball.dipw"), "ball", {}), {});
    }

    void stop_runningJob_isQueuedAgainWhileTheServerAnswers() {
        start();
        ServerClient client = connected();
        const QString id = client.submit(path("wait.dipw"), "a", {});
        QTRY_COMPARE(spool_->job(id)->state, ServedState::Running);
        spool_->stop();
        QTRY_COMPARE(client.job(id)["state"].toString(), "queued");
    }

    void run_tooLong_fails() {
        limits_.mostSeconds = 0;
        start();
        ServerClient client = connected();
        const QString id = client.submit(path("wait.dipw"), "a", {});
        QTRY_COMPARE(spool_->job(id)->state, ServedState::Failed);
        QVERIFY(spool_->job(id)->text.contains("longer"));
    }

    void run_failingJob_tellsWhy() {
        start();
        ServerClient client = connected();
        const QString id = client.submit(path("fail.dipw"), "a", {});
        try {
            client.wait(id, {});
            QFAIL("did not fail");
        } catch (const Error& error) {
            QVERIFY(error.message().contains("This job fails"));
        }
    }

    void restart_jobsOfEveryState_survive() {
        start();
        ServerClient client = connected();
        const QString done = client.submit(path("ball.dipw"), "done", {});
        client.wait(done, {});
        const QString running = client.submit(path("wait.dipw"), "running", {});
        const QString queued = client.submit(path("ball.dipw"), "queued", {});
        QTRY_COMPARE(spool_->job(running)->state, ServedState::Running);
        stop();
        QVERIFY(!QFile::exists(socket_));
        QVERIFY(QFile::exists(path("jobs/queued/" + running + ".dipw")));
        start();
        QCOMPARE(spool_->job(done)->name, "done");
        QCOMPARE(spool_->files(done).size(), 2);
        QTRY_COMPARE(spool_->job(running)->state, ServedState::Running);
        spool_->cancel(running);
        QTRY_COMPARE(spool_->job(queued)->state, ServedState::Done);
    }

    void restart_afterCrash_failsTheRunningJobAndDropsUploads() {
        QDir().mkpath(path("jobs/running"));
        QDir().mkpath(path("jobs/incoming"));
        writeFile(path("jobs/running/20260101T000000000-1.dipw"), project);
        writeFile(path("jobs/incoming/20260101T000000000-2.dipw"), project.left(9));
        start();
        const auto job = spool_->job("20260101T000000000-1");
        QVERIFY(job && job->state == ServedState::Failed);
        QCOMPARE(filesBelow(path("jobs/incoming")), QStringList());
    }

    void fetch_nameOutsideTheResults_isRefused() {
        start();
        ServerClient client = connected();
        const QString id = client.submit(path("ball.dipw"), "ball", {});
        client.wait(id, {});
        for (const char* name : {"..%2Freport.json", "../report.json", "%2Fetc%2Fpasswd",
                                 "immersion-1/../report.json", "immersion-1"}) {
            const QByteArray line = "GET /v1/jobs/" + id.toLatin1() + "/files/" + name;
            QVERIFY2(talk(socket_, request(line, token, "\r\n")).contains(" 404 "), name);
        }
        QVERIFY(talk(socket_, request("GET /v1/jobs/..", token, "\r\n")).contains(" 404 "));
    }

    void otherMethod_knownAddress_isNotAllowed() {
        start();
        const std::pair<QByteArray, QByteArray> allowed[]{
            {"PUT /v1/jobs", "GET, HEAD, POST"},
            {"DELETE /v1/status", "GET, HEAD"},
            {"PATCH /v1/jobs/1", "DELETE, GET, HEAD"},
            {"GET /v1/jobs/1/cancel", "POST"},
            {"OPTIONS /v1/jobs/1/files/a", "GET, HEAD"}};
        for (const auto& [line, methods] : allowed) {
            const QByteArray answer = talk(socket_, request(line, token, "\r\n"));
            QVERIFY2(answer.contains(" 405 "), answer);
            QVERIFY2(answer.contains("Allow: " + methods + "\r\n"), answer);
        }
    }

    void socket_otherUser_cannotConnect() {
        start();
        QCOMPARE(int(QFile::permissions(socket_) &
                     (QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther)),
                 0);
        if (geteuid() != 0) {
            return; // only root can become another user
        }
        QFile::setPermissions(folder_->path(),
                              QFile::Permissions(0x7755)); // only the socket's mode
        QProcess stranger;
        stranger.start(
            "setpriv",
            {"--reuid=65534", "--regid=65534", "--clear-groups", "/usr/bin/python3", "-c",
             "import socket,sys; socket.socket(socket.AF_UNIX).connect(sys.argv[1])", socket_});
        QVERIFY(stranger.waitForFinished());
        const QByteArray text = stranger.readAllStandardError();
        QVERIFY2(text.contains("PermissionError"), text);
        requireNothing();
    }

    void socket_inUseOrNoSocket_isRefused() {
        start();
        JobSpool other(path("other"), limits_, fakeRun);
        QVERIFY_EXCEPTION_THROWN(JobServer(serverAddress(socket_), token, other, checkProject),
                                 Error);
        QVERIFY_EXCEPTION_THROWN(
            JobServer(serverAddress(path("ball.dipw")), token, other, checkProject), Error);
        QVERIFY_EXCEPTION_THROWN(JobSpool(path("jobs"), limits_, fakeRun), Error); // locked
    }

    void port_onLoopback_serves() {
        spool_ = std::make_unique<JobSpool>(path("jobs"), limits_, fakeRun);
        ServerAddress address;
        for (address.port = 20'000 + int(getpid() % 20'000); !server_; ++address.port) {
            try {
                server_ = std::make_unique<JobServer>(address, token, *spool_, checkProject);
                break;
            } catch (const Error&) { // in use
            }
        }
        QVERIFY_EXCEPTION_THROWN(JobServer(address, token, *spool_, checkProject), Error);
        ServerClient client(address, token);
        client.wait(client.submit(path("ball.dipw"), "ball", {}), {});
        ServerClient stranger(address, "wrong");
        QVERIFY_EXCEPTION_THROWN(stranger.status(), Error);
    }

    void serverAddress_outsideLoopback_isRefused() {
        QCOMPARE(serverAddress("8137").text(), "127.0.0.1:8137");
        QCOMPARE(serverAddress("localhost:8137").text(), "127.0.0.1:8137");
        QCOMPARE(serverAddress("http://127.0.0.1:8137/").port, 8137);
        QCOMPARE(serverAddress("[::1]:8137").text(), "[::1]:8137");
        QCOMPARE(serverAddress("/run/jobs.sock").socket, "/run/jobs.sock");
        for (const char* address : {"0.0.0.0:8137", "192.168.1.5:8137", "example.com:8137",
                                    "[::]:1", "", "0", "99999", "host", "127.0.0.1"}) {
            QVERIFY_EXCEPTION_THROWN(serverAddress(address), Error);
        }
    }

    void tokenIn_newFile_isSecretAndKept() {
        const QByteArray made = tokenIn(path("token"));
        QVERIFY(made.size() >= 43);
        QCOMPARE(tokenIn(path("token")), made);
        QFile::setPermissions(path("token"), QFile::ReadOwner | QFile::ReadOther);
        QVERIFY_EXCEPTION_THROWN(tokenIn(path("token")), Error);
        writeFile(path("short"), "abc");
        QFile::setPermissions(path("short"), QFile::ReadOwner);
        QVERIFY_EXCEPTION_THROWN(tokenIn(path("short")), Error);
    }

    void openApi_document_describesEveryRequest() {
        const QJsonObject api =
            QJsonDocument::fromJson(bytesOf(sourceFolder("/docs/serve-openapi.json"))).object();
        QVERIFY(api["openapi"].toString().startsWith("3."));
        QCOMPARE(api["paths"].toObject().keys(),
                 (QStringList{"/v1/jobs", "/v1/jobs/{id}", "/v1/jobs/{id}/cancel",
                              "/v1/jobs/{id}/files/{name}", "/v1/status"}));
        start();
        ServerClient client = connected();
        const QString id = client.submit(path("ball.dipw"), "ball", {});
        const QJsonObject job = client.wait(id, {});
        const QJsonObject known = api["components"]
                                      .toObject()["schemas"]
                                      .toObject()["Job"]
                                      .toObject()["properties"]
                                      .toObject();
        QCOMPARE(job.keys(), known.keys());
    }

private:
    QString path(const QString& name) const { return folder_->filePath(name); }
    ServerClient connected() const { return {serverAddress(socket_), token}; }
    void start() {
        socket_ = path("serve.sock");
        spool_ = std::make_unique<JobSpool>(path("jobs"), limits_, fakeRun);
        server_ = std::make_unique<JobServer>(serverAddress(socket_), token, *spool_, checkProject);
    }
    void stop() {
        server_.reset();
        spool_.reset();
    }
    // Waits, since a server may end what it does with a request after its client has left.
    void requireNothing() const {
        QTRY_VERIFY(spool_->jobs().empty());
        for (const char* folder : {"jobs/incoming", "jobs/queued", "jobs/records"}) {
            QTRY_COMPARE(filesBelow(path(folder)), QStringList());
        }
    }

    std::unique_ptr<QTemporaryDir> folder_;
    SpoolLimits limits_;
    std::unique_ptr<JobSpool> spool_;
    std::unique_ptr<JobServer> server_;
    QString socket_;
};

QTEST_GUILESS_MAIN(ServeTest)
#include "ServeTest.moc"
