#include "PrivateCups.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTcpServer>
#include <QTcpSocket>
#include <QtTest>
#ifdef Q_OS_LINUX
#include <csignal>
#include <sys/prctl.h>
#endif

namespace dipwright {
namespace {

// Milliseconds; long enough for a machine that also runs other tests.
constexpr int timeout = 20000;

// Also finds system programs, which are not in an ordinary user's path.
QString programPath(const QString& name) {
    const QString found = QStandardPaths::findExecutable(name);
    return found.isEmpty()
               ? QStandardPaths::findExecutable(name, {"/usr/sbin", "/sbin", "/usr/local/sbin"})
               : found;
}

// Makes the process end with the test, even if the test crashes.
void endWithTheTest(QProcess& process) {
#ifdef Q_OS_LINUX
    process.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGTERM); });
#else
    Q_UNUSED(process);
#endif
}

bool answers(quint16 port) {
    QTcpSocket socket;
    socket.connectToHost(QHostAddress::LocalHost, port);
    return socket.waitForConnected(200);
}

QByteArray collection(const TestMedia& media) {
    const QByteArray margin = QByteArray::number(int(std::lround(media.margin * 100)));
    QByteArray text = "{ MEMBER collection media-size { MEMBER integer x-dimension " +
                      QByteArray::number(int(std::lround(media.width * 100))) +
                      " MEMBER integer y-dimension " +
                      QByteArray::number(int(std::lround(media.height * 100))) + " }";
    for (const char* side : {"bottom", "left", "right", "top"}) {
        text += " MEMBER integer media-" + QByteArray(side) + "-margin " + margin;
    }
    return text + " }";
}

QByteArray attributes(const TestPrinter& printer) {
    QByteArrayList keywords;
    QByteArrayList sizes;
    QByteArrayList collections;
    QByteArrayList margins;
    QByteArrayList loadedKeywords;
    QByteArrayList loaded;
    for (const TestMedia& media : printer.media) {
        keywords << '"' + media.keyword.toUtf8() + '"';
        sizes << "{ MEMBER integer x-dimension " +
                     QByteArray::number(int(std::lround(media.width * 100))) +
                     " MEMBER integer y-dimension " +
                     QByteArray::number(int(std::lround(media.height * 100))) + " }";
        collections << collection(media);
        margins << QByteArray::number(int(std::lround(media.margin * 100)));
        if (media.loaded) {
            loadedKeywords << keywords.back();
            loaded << collections.back();
        }
    }
    QByteArray text = "ATTR keyword media-supported " + keywords.join(',') +
                      "\nATTR keyword media-default " + keywords.front() +
                      "\nATTR keyword media-ready " + loadedKeywords.join(',') +
                      "\nATTR collection media-size-supported " + sizes.join(',') +
                      "\nATTR collection media-col-database " + collections.join(',') +
                      "\nATTR collection media-col-default " + collections.front() +
                      "\nATTR collection media-col-ready " + loaded.join(',') + '\n';
    for (const char* side : {"bottom", "left", "right", "top"}) {
        text += "ATTR integer media-" + QByteArray(side) + "-margin-supported " +
                margins.join(',') + '\n';
    }
    text += printer.colour
                ? "ATTR boolean color-supported true\n"
                  "ATTR keyword print-color-mode-supported \"auto\",\"color\",\"monochrome\"\n"
                  "ATTR keyword print-color-mode-default color\n"
                  "ATTR keyword pwg-raster-document-type-supported \"sgray_8\",\"srgb_8\"\n"
                  "ATTR keyword urf-supported \"CP1\",\"RS300\",\"SRGB24\",\"V1.4\",\"W8\"\n"
                : "ATTR boolean color-supported false\n"
                  "ATTR keyword print-color-mode-supported \"auto\",\"monochrome\"\n"
                  "ATTR keyword print-color-mode-default monochrome\n"
                  "ATTR keyword pwg-raster-document-type-supported \"sgray_8\"\n"
                  "ATTR keyword urf-supported \"CP1\",\"RS300\",\"V1.4\",\"W8\"\n";
    return text + "ATTR keyword print-scaling-supported \"auto\",\"auto-fit\",\"fill\",\"fit\"" +
           (printer.canForbidScaling ? ",\"none\"\n" : "\n") +
           "ATTR keyword print-scaling-default " + printer.scaling.toUtf8() +
           "\nATTR mimeMediaType document-format-supported "
           "\"application/octet-stream\",\"application/pdf\",\"image/pwg-raster\"\n";
}

} // namespace

PrivateCups::PrivateCups() {
    // If root starts the scheduler, it works as another user, who needs access to the folder.
    QFile::setPermissions(folder_.path(), QFile::Permissions(0x7755));
    for (const char* name : {"root", "spool", "cache", "state", "log", "tmp"}) {
        QDir().mkpath(folder_.filePath(name));
    }
    QFile::setPermissions(folder_.filePath("tmp"), QFile::Permissions(0x7777));
    if (startBus()) {
        startScheduler();
    }
}

PrivateCups::~PrivateCups() {
    for (auto& [name, device] : devices_) {
        device.process->terminate();
        device.process->waitForFinished(timeout);
    }
    for (QProcess* process : {&scheduler_, &bus_}) {
        process->terminate();
        process->waitForFinished(timeout);
    }
}

bool PrivateCups::write(const QString& name, const QByteArray& text) const {
    QFile file(folder_.filePath(name));
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

bool PrivateCups::startBus() {
    const QByteArray address = "unix:path=" + path("bus");
    endWithTheTest(bus_);
    bus_.start(programPath("dbus-daemon"),
               {"--session", "--nofork", "--nopidfile", "--address=" + QString::fromUtf8(address)});
    qputenv("DBUS_SYSTEM_BUS_ADDRESS", address);
    if (!bus_.waitForStarted() ||
        !QTest::qWaitFor([&] { return QFileInfo::exists(folder_.filePath("bus")); }, timeout)) {
        problem_ = "dbus-daemon does not start: " + bus_.errorString();
        return false;
    }
    return true;
}

bool PrivateCups::startScheduler() {
    write("cupsd.conf", "LogLevel warn\nListen " + path("socket") +
                            "\nBrowsing Off\nWebInterface No\nDefaultAuthType None\nErrorPolicy "
                            "stop-printer\nJobRetryInterval 1\n"
                            "<Location />\nOrder allow,deny\nAllow all\n</Location>\n"
                            "<Policy default>\nJobPrivateAccess all\nJobPrivateValues none\n"
                            "SubscriptionPrivateAccess all\nSubscriptionPrivateValues none\n"
                            "<Limit All>\nOrder deny,allow\n</Limit>\n</Policy>\n");
    write("cups-files.conf", "ServerRoot " + path("root") + "\nRequestRoot " + path("spool") +
                                 "\nCacheDir " + path("cache") + "\nStateDir " + path("state") +
                                 "\nTempDir " + path("tmp") + "\nAccessLog " + path("log/access") +
                                 "\nErrorLog " + path("log/error") + "\nPageLog " +
                                 path("log/page") +
                                 "\nFileDevice Yes\nUser lp\nGroup lp\nSystemGroup lpadmin\n");
    scheduler_.setStandardErrorFile(folder_.filePath("log/cupsd"));
    endWithTheTest(scheduler_);
    scheduler_.start(programPath("cupsd"), {"-f", "-c", folder_.filePath("cupsd.conf"), "-s",
                                            folder_.filePath("cups-files.conf")});
    qputenv("CUPS_SERVER", path("socket"));
    const auto runs = [] {
        QProcess process; // its exit code is always 0
        process.start(programPath("lpstat"), {"-r"});
        return process.waitForFinished(timeout) &&
               process.readAllStandardOutput().contains("is running");
    };
    if (!scheduler_.waitForStarted() || !QTest::qWaitFor(runs, timeout)) {
        problem_ = "cupsd does not start: " + scheduler_.errorString();
        return false;
    }
    return true;
}

bool PrivateCups::command(const QString& program, const QStringList& arguments) const {
    QProcess process;
    process.start(programPath(program), arguments);
    return process.waitForFinished(timeout) && process.exitStatus() == QProcess::NormalExit &&
           process.exitCode() == 0;
}

// Writes the program to which a printer passes its jobs. The attributes of a job are in the
// program's environment. Without such a program, ippeveprinter simulates a slow printer, about ten
// seconds per job.
QString PrivateCups::jobCommand(const TestPrinter& printer) const {
    const QString name = "job-" + printer.name;
    const QByteArray end = printer.trouble.isEmpty() ? "exit 0\n"
                                                     : "echo 'STATE: +" + printer.trouble.toUtf8() +
                                                           "' >&2\nexec sleep 30\n";
    write(name, "#!/bin/sh\nenv > '" + path("device-" + printer.name) + "/told'\n" + end);
    QFile::setPermissions(folder_.filePath(name), QFile::Permissions(0x7755));
    return folder_.filePath(name);
}

bool PrivateCups::add(const TestPrinter& printer) {
    Device device;
    device.folder = folder_.filePath("device-" + printer.name);
    QDir().mkpath(device.folder);
    const QString description = "attributes-" + printer.name;
    write(description, attributes(printer));
    const quint16 port = freePort();
    device.process = std::make_unique<QProcess>();
    device.process->setStandardOutputFile(QProcess::nullDevice());
    device.process->setStandardErrorFile(QProcess::nullDevice());
    endWithTheTest(*device.process);
    device.process->start(programPath("ippeveprinter"),
                          {"-r", "off", "-k", "-c", jobCommand(printer), "-d", device.folder, "-p",
                           QString::number(port), "-a", folder_.filePath(description),
                           printer.name});
    if (!device.process->waitForStarted() ||
        !QTest::qWaitFor([&] { return answers(port); }, timeout)) {
        return false;
    }
    devices_[printer.name] = std::move(device);
    // lpadmin returns before CUPS has asked the printer for its capabilities.
    const QString ppd = folder_.filePath("root/ppd/" + printer.name + ".ppd");
    return command("lpadmin",
                   {"-p", printer.name, "-E", "-v",
                    QString("ipp://localhost:%1/ipp/print").arg(port), "-m", "everywhere"}) &&
           QTest::qWaitFor([&] { return QFileInfo::exists(ppd); }, timeout);
}

quint16 PrivateCups::freePort() {
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    return server.serverPort();
}

bool PrivateCups::addQueue(const QString& name, const QString& device, const QString& like) const {
    return command("lpadmin", {"-p", name, "-E", "-v", device, "-P",
                               folder_.filePath("root/ppd/" + like + ".ppd")});
}

bool PrivateCups::addFileQueue(const QString& name, const QByteArray& ppd) const {
    const QString file = name + "-model.ppd";
    return write(file, ppd) && write(name + ".pdf", {}) &&
           QFile::setPermissions(filePrinted(name), QFile::Permissions(0x6666)) &&
           command("lpadmin", {"-p", name, "-E", "-v", "file://" + filePrinted(name), "-P",
                               folder_.filePath(file)});
}

void PrivateCups::switchOff(const QString& printer) {
    QProcess& process = *devices_.at(printer).process;
    process.kill();
    process.waitForFinished(timeout);
}

QStringList PrivateCups::received(const QString& printer) const {
    const QDir folder(devices_.at(printer).folder);
    // Sorts the files by the printer's job number ("1-Top.pdf"). The printer's logs lie in the same
    // folder.
    QFileInfoList files = folder.entryInfoList({"*.pdf"}, QDir::Files);
    std::sort(files.begin(), files.end(), [](const QFileInfo& a, const QFileInfo& b) {
        return a.fileName().section('-', 0, 0).toInt() < b.fileName().section('-', 0, 0).toInt();
    });
    QStringList paths;
    for (const QFileInfo& file : files) {
        paths << file.filePath();
    }
    return paths;
}

QByteArray PrivateCups::receivedAttribute(const QString& printer,
                                          const QByteArray& attribute) const {
    QFile file(QDir(devices_.at(printer).folder).filePath("told"));
    file.open(QIODevice::ReadOnly);
    const QByteArray name = "IPP_" + attribute.toUpper().replace('-', '_') + "=";
    for (const QByteArray& line : file.readAll().split('\n')) {
        if (line.startsWith(name)) {
            return line.mid(name.size());
        }
    }
    return {};
}

} // namespace dipwright
