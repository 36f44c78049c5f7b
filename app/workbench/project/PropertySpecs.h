// Labels and explains every value of the schema, grouped by the parts of a project.
#pragma once

#include "project/FilmFields.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/project/PropertyField.h"

namespace dipwright {

struct Project;

struct PropertySection {
    QString title; // empty: none
    std::vector<PropertySpec> specs;
};

// Describes the film's material value at `path`.
PropertySpec specOf(const QString& path, const FieldWords& words);

// Returns the name of a tree node: "Film", "Dipping", or the name of the project or dip.
QString partName(const ProjectNode& node, const Project& project);

std::vector<PropertySection> propertySections(const ProjectNode& node);

// The node that shows the field `path`; nothing if no node shows it.
std::optional<ProjectNode> nodeOfField(const QString& path);

} // namespace dipwright
