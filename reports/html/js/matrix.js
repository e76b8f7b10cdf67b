// The cases at a glance, coloured by how far they are from their limits.

function matrix() {}
