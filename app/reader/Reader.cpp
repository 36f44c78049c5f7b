#include "reader/Reader.h"

#include <QCoreApplication>
#include <QTranslator>

#include <cstdlib>
#include <new>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Reader)
};

// Returns whether the user has allowed reading without a sandbox. Meant for systems without one and
// for trusted files.
bool mayReadUnconfined() {
    return qEnvironmentVariableIsSet("DIPWRIGHT_READ_UNCONFINED");
}

void read(const ReaderJob& job, Pipe& pipe, const ReaderProgram& program) {
    try {
        program.read(job, pipe);
    } catch (const Error& error) {
        pipe.fail(error);
    } catch (const std::bad_alloc&) {
        pipe.fail(Error(sentenceOf(program.limits.memory, pipe.bytesRead()), job.names.value(0)));
    }
}

} // namespace

void runReader(int argc, char* argv[], const ReaderProgram& program) {
    closeInheritedFiles();
    const QCoreApplication application(argc, argv);
    Pipe pipe(program.limits);
    const ReaderJob job = pipe.readJob();
    QTranslator translator;
    if (translator.load(QStringLiteral(":/translations/dipwright_") + job.language)) {
        QCoreApplication::installTranslator(&translator);
    }
    program.prepare();
    if (enterSandbox(program.limits) || mayReadUnconfined()) {
        read(job, pipe, program);
    } else {
        pipe.fail(Error(Text::tr("This operating system cannot run the reader of models and "
                                 "pictures in a sandbox, so nothing was read. Use another system, "
                                 "or set DIPWRIGHT_READ_UNCONFINED=1 for files that you trust"),
                        job.names.value(0)));
    }
    // Skips all clean-up, because a foreign file may have corrupted the memory.
    std::_Exit(EXIT_SUCCESS);
}

} // namespace dipwright
