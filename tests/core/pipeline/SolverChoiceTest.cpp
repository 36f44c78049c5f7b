// Tests which solver is chosen, and when the CPU takes over from a GPU.
#include "pipeline/SolverChoice.h"
#include "PluginFolder.h"
#include "TestFolders.h"

#include <QtTest>

using namespace dipwright;
using test::PluginFolder;

namespace {

// Adds a module whose description says that it needs a GPU.
void addGpu(const PluginFolder& folder, const char* module, const QString& path) {
    const QString id = QString::fromLatin1(module);
    folder.add(id, path);
    QJsonObject description = PluginFolder::description(id);
    description[QLatin1String("device")] = QStringLiteral("gpu");
    description[QLatin1String("priority")] = 1000;
    folder.describe(description);
}

QString cpuModule() {
    return pluginFolder("/") + PluginFolder::moduleName("pbd-cpu");
}

} // namespace

class SolverChoiceTest : public QObject {
    Q_OBJECT

private slots:
    void chooseSolver_auto_givesTheChosenId() {
        const SolverRegistry registry({pluginFolder()});
        const SolverChoice choice = chooseSolver(QStringLiteral("auto"), registry);
        QCOMPARE(choice.solver.id, QStringLiteral("pbd-cpu"));
        QVERIFY(choice.notes.isEmpty());
        QVERIFY_EXCEPTION_THROWN(chooseSolver(QStringLiteral("no-such"), registry), Error);
    }

    void chooseSolver_gpuMissing_choosesTheCpu() {
        const PluginFolder folder;
        addGpu(folder, "device", badModuleFolder("/") + PluginFolder::moduleName("device"));
        const SolverRegistry registry({folder.path(), pluginFolder()});
        const SolverChoice choice = chooseSolver(QStringLiteral("device"), registry);
        QCOMPARE(choice.solver.id, QStringLiteral("pbd-cpu"));
        QCOMPARE(choice.notes.size(), 1);
        QVERIFY(choice.notes[0].contains("The CPU is used instead"));
        const SolverRegistry alone({folder.path()});
        QVERIFY_EXCEPTION_THROWN(chooseSolver(QStringLiteral("device"), alone), Error);
    }

    void withFallback_gpuFails_repeatsOnTheCpu() {
        const PluginFolder folder;
        addGpu(folder, "gpu", cpuModule());
        const SolverRegistry registry({folder.path(), pluginFolder()});
        SolverChoice choice = chooseSolver(QStringLiteral("auto"), registry);
        QCOMPARE(choice.solver.id, QStringLiteral("gpu"));
        int tried = 0;
        const auto work = [&](const solver::SolverModule& module) {
            ++tried;
            if (&module == &registry.module(QStringLiteral("gpu"))) {
                throw Error(QStringLiteral("Out of memory"), QStringLiteral("gpu"));
            }
            return 7;
        };
        QCOMPARE(withFallback(choice, registry, work), 7);
        QCOMPARE(tried, 2);
        QCOMPARE(choice.solver.id, QStringLiteral("pbd-cpu"));
        QVERIFY(choice.notes.size() == 1 && choice.notes[0].contains("Out of memory"));
        // The CPU stays chosen.
        QCOMPARE(withFallback(choice, registry, work), 7);
        QCOMPARE(tried, 3);
        QCOMPARE(choice.notes.size(), 1);
    }

    void withFallback_cpuFails_throwsError() {
        const SolverRegistry registry({pluginFolder()});
        SolverChoice choice = chooseSolver(QStringLiteral("pbd-cpu"), registry);
        const auto work = [](const solver::SolverModule&) -> int {
            throw Error(QStringLiteral("No"), QStringLiteral("here"));
        };
        QVERIFY_EXCEPTION_THROWN(withFallback(choice, registry, work), Error);
        QVERIFY(choice.notes.isEmpty());
    }
};

QTEST_GUILESS_MAIN(SolverChoiceTest)
#include "SolverChoiceTest.moc"
