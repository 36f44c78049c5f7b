// Lists the solver plugins with version and device, or the reason why one cannot run here.
#pragma once

#include "solver/SolverRegistry.h"

#include <QWidget>

class QTreeWidget;

namespace dipwright {

class SolverPage : public QWidget {
    Q_OBJECT

public:
    explicit SolverPage(const SolverRegistry& registry, QWidget* parent = nullptr);

private:
    void show(const std::vector<SolverInfo>& solvers);

    QTreeWidget* list_;
};

} // namespace dipwright
