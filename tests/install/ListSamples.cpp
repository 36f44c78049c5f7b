// Prints the samples that a program in this program's folder finds, one per line.
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
