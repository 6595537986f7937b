"""Bundle: a folder from which laptops install zbot without the internet."""
