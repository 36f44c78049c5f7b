// Edits the values of the entry selected in the project tree, with unit, range and explanation.
#pragma once

#include "project/ProfileLibrary.h"
#include "solver/SolverRegistry.h"
#include "workbench/document/MarkEdits.h"
#include "workbench/project/FilmFacts.h"
#include "workbench/project/PrintFields.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/project/PropertyField.h"

#include <QScrollArea>

class QComboBox;
class QFormLayout;

namespace dipwright {

struct Project;

class MarkFields;
struct PropertySection;

class PropertyPanel : public QScrollArea {
    Q_OBJECT

public:
    // Offers the registry's solvers; the registry must outlive the panel.
    explicit PropertyPanel(const SolverRegistry& registry, QWidget* parent = nullptr);

    void setDocument(Document* document); // may be null
    void setLengthUnit(LengthUnit unit);
    void showNode(const ProjectNode& node);
    void showField(const QString& path); // scrolls to a field of the shown node
    void refresh();                      // call this when profiles have changed

signals:
    // Emitted before the panel's minimum width becomes `width`, because of another page.
    void leastWidthChanging(int width);
    void failed(const QString& sentence);
    void edited(); // a value was accepted
    void reloadModelAsked();
    void tessellationAsked(dipwright::Millimetres tolerance);
    void replaceModelAsked();
    void replaceTextureAsked();
    // The print to show on the body. It affects only the view.
    void shownPrintChanged(const dipwright::ShownPrint& print);
    // The pose of the dip's path that the view shows and changes; −1: none.
    void pathKeyChosen(int key);
    // What a click on the body marks.
    void brushChanged(const dipwright::MarkBrush& brush);
    void tolerancesAsked();

private:
    void rebuild();
    void addSection(QFormLayout& form, const PropertySection& section);
    QWidget* addHeading(QFormLayout& form, const QString& text);
    void addField(QFormLayout& form, const PropertySpec& spec);
    void addModelFacts(QFormLayout& form);
    void addModelSize(QFormLayout& form);
    void addTessellation(QFormLayout& form);
    void markByName(const MarkBrush& brush, const QString& name);
    void addFilmFacts(QFormLayout& form);
    template <typename Mark>
    void addMarkFields(QFormLayout& form, const QString& heading, MarkFields& fields);
    void addSeamFields(QFormLayout& form);
    void addPathKeys(QFormLayout& form);
    void addPrintFields(QFormLayout& form);
    void addZoneFields(QFormLayout& form);
    void addMaskFields(QFormLayout& form);
    void addTolerancesButton(QFormLayout& form);
    void addPreset(QFormLayout& form);
    void addSolver(QFormLayout& form);
    static void listSolvers(QComboBox& box, const std::vector<SolverInfo>& solvers);
    void addProfile(QFormLayout& form, ProfileKind kind, const QString& name, const QString& help);
    void edit(const QString& text, const QString& mergeKey,
              const std::function<void(Project&)>& change);

    const SolverRegistry& registry_;
    ProfileLibrary profiles_;
    FilmFacts filmFacts_;
    Document* document_ = nullptr;
    LengthUnit lengthUnit_ = LengthUnit::Millimetre;
    ProjectNode node_;
    std::vector<std::function<void()>> refreshers_; // for the fields that are shown
};

} // namespace dipwright
