// Runs a separate print system for the test: a CUPS scheduler with its own folders and socket, IPP
// software printers (ippeveprinter), and the message bus that they need. Changes nothing else on
// the machine. All processes end when the object is destroyed.
#pragma once

#include <QProcess>
#include <QTemporaryDir>
#include <map>
#include <memory>
#include <vector>

namespace dipwright {

struct TestMedia {
    QString keyword; // for example "iso_a4_210x297mm"
    double width = 210, height = 297;
    double margin = 0; // margin on each side, mm
    bool loaded = true;
};

struct TestPrinter {
    QString name;
    bool colour = true;
    std::vector<TestMedia> media{{"iso_a4_210x297mm", 210, 297, 0}};
    QString scaling = QStringLiteral("auto"); // for jobs that do not set print-scaling
    // A state that the printer reports for a job ("media-empty-error") and keeps for half a minute.
    // If empty, the printer prints.
    QString trouble = {};
    bool canForbidScaling = true; // whether it supports print-scaling "none"
};

class PrivateCups {
public:
    // Starts the scheduler. If that fails, problem() returns the reason.
    PrivateCups();
    ~PrivateCups();
    QString problem() const { return problem_; }

    // Starts a printer and makes its queue. Returns whether they are ready.
    bool add(const TestPrinter& printer);
    // Makes a queue for the device URI `device`. It has the same paper as the printer `like`.
    bool addQueue(const QString& name, const QString& device, const QString& like) const;
    // Makes a queue with the PPD file's text. Its documents are written to filePrinted(name).
    bool addFileQueue(const QString& name, const QByteArray& ppd) const;
    QString filePrinted(const QString& name) const { return folder_.filePath(name + ".pdf"); }
    // Returns a port on which nobody listens.
    static quint16 freePort();
    // Runs one of CUPS's own commands, for example "cupsdisable office".
    bool command(const QString& program, const QStringList& arguments) const;
    // Switches a printer off. Its queue stays.
    void switchOff(const QString& printer);
    // Returns the documents that a printer received, in the order of its jobs.
    QStringList received(const QString& printer) const;
    // Returns an attribute ("print-scaling") of the last job that a printer received; empty if the
    // job has no such attribute.
    QByteArray receivedAttribute(const QString& printer, const QByteArray& attribute) const;

private:
    struct Device {
        std::unique_ptr<QProcess> process;
        QString folder;
    };
    QString jobCommand(const TestPrinter& printer) const;
    bool startBus();
    bool startScheduler();
    bool write(const QString& name, const QByteArray& text) const;
    QByteArray path(const QString& name) const { return folder_.filePath(name).toUtf8(); }

    QTemporaryDir folder_;
    QProcess bus_;
    QProcess scheduler_;
    std::map<QString, Device> devices_;
    QString problem_;
};

} // namespace dipwright
