// A print system of the test's own: a CUPS scheduler with its own folders and socket, real IPP
// printers in software behind it (ippeveprinter), and the message bus that those ask for. Nothing
// of the machine's is touched, and everything ends with the object.
#pragma once

#include <QProcess>
#include <QTemporaryDir>
#include <map>
#include <memory>
#include <vector>

namespace dipwright {

struct TestMedia {
    QString keyword; // "iso_a4_210x297mm"
    double width = 210, height = 297;
    double margin = 0; // mm, all round
    bool loaded = true;
};

struct TestPrinter {
    QString name;
    bool colour = true;
    std::vector<TestMedia> media{{"iso_a4_210x297mm", 210, 297, 0}};
    QString scaling = QStringLiteral("auto"); // what it does with a job that says nothing of it
    // What it reports when it gets a job ("media-empty-error"), on which it then stays for half a
    // minute; empty: it prints.
    QString trouble = {};
    bool takesTrueSize = true; // whether it knows print-scaling "none"
};

class PrivateCups {
public:
    // Starts the scheduler; `problem()` says what went wrong.
    PrivateCups();
    ~PrivateCups();
    QString problem() const { return problem_; }

    // A printer and its queue, ready to print.
    bool add(const TestPrinter& printer);
    // A queue to a device by its URI, which takes the same paper as the printer `like`.
    bool addQueue(const QString& name, const QString& device, const QString& like) const;
    // A port at which nobody is.
    static quint16 freePort();
    // Runs one of CUPS's own commands, "cupsdisable office".
    bool command(const QString& program, const QStringList& arguments) const;
    // A printer is switched off, its queue stays.
    void switchOff(const QString& printer);
    // The documents that a printer has got, in the order of its jobs.
    QStringList received(const QString& printer) const;
    // What the last job that a printer printed said of an attribute ("print-scaling"); empty: none.
    QByteArray told(const QString& printer, const QByteArray& attribute) const;

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
