// SPDX-License-Identifier: GPL-3.0-or-later
in float vHeight;
out float oHeight;

void main()
{
    oHeight = vHeight;
}
