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

/// Every parameter that can be turned, in groups, with range, unit, what it does and a way back; made from the registry
/// that the console has.
class SettingsPage : public kit::Page
{
    Q_OBJECT
public:
    /// @param parameters  must outlive the page; all of them registered by now
    SettingsPage(const kit::Actions& actions, const core::settings::Parameters& parameters, QWidget* parent);

    /// Shows what the values are now.
    void refresh();

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Row
    {
        QWidget* whole = nullptr;
        QLabel* group = nullptr;  ///< heading that it stands under
        std::string name;
        QString words;  ///< that a search looks through
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
    QLabel* m_blind;  ///< why what is felt is not told
    QWidget* m_content;
    QVBoxLayout* m_column;
    QLabel* m_none;  ///< nothing is found
    std::vector<Row> m_rows;
    bool m_isQuiet = false;
};

}  // namespace ui::settings
