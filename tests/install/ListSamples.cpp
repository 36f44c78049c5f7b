// Says which samples a program finds that lies where this one lies.
#include "project/Samples.h"

#include <QCoreApplication>
#include <QTextStream>

int main(int argc, char* argv[]) {
    const QCoreApplication application(argc, argv);
    QTextStream out(stdout);
    for (const QString& path : dipwright::sampleProjects()) {
        out << path << '\n';
    }
    return 0;
}
