// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "core/settings/Parameters.h"
#include "ui/kit/Page.h"

class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace ui::settings {

/// The page of all settings, in groups, each with range, unit, explanation and a reset button. It is generated from the
/// registry that the console also uses.
class SettingsPage : public kit::Page
{
    Q_OBJECT
public:
    /// @param parameters  must outlive the page, and must be complete
    SettingsPage(const kit::Actions& actions, const core::settings::Parameters& parameters, QWidget* parent);

    /// Shows the current values.
    void refresh();

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Row
    {
        QWidget* whole = nullptr;
        QLabel* group = nullptr;  ///< the heading above it
        std::string name;
        QString words;  ///< text that the search field searches
        std::function<void()> show;
    };
    void fill();
    void addWindowRows();
    QWidget* makeRow(const core::settings::Parameter& parameter, QWidget* parent, Row& row);
    void set(const std::string& name, double value);
    void search(const QString& words);

    const kit::Actions& m_actions;
    const core::settings::Parameters& m_parameters;
    QLineEdit* m_search;
    QLabel* m_fault;
    QLabel* m_blind;  ///< why the values of the feel are hidden
    QWidget* m_content;
    QVBoxLayout* m_column;
    QLabel* m_none;  ///< shown if a search finds nothing
    std::vector<Row> m_rows;
    bool m_isQuiet = false;
};

}  // namespace ui::settings
