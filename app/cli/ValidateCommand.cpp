#include "cli/Arguments.h"

#include "pipeline/ValidateJob.h"

namespace dipwright::cli {
namespace {

class ValidateCommand : public Command {
public:
    QString name() const override { return QStringLiteral("validate"); }
    QString summary() const override {
        return QStringLiteral("Tells whether a project can be run, and what to look at first.");
    }
    void declare(QCommandLineParser& parser) const override { declareProject(parser); }
    void run(const QCommandLineParser& parser, Console& console) const override {
        const Project project = projectArgument(parser);
        const SolverRegistry registry;
        for (const QString& warning : validateJob(project, registry)) {
            console.out() << "warning: " << warning << '\n';
        }
        console.out() << "The project can be run\n";
    }
};

} // namespace

std::unique_ptr<Command> validateCommand() {
    return std::make_unique<ValidateCommand>();
}

} // namespace dipwright::cli
